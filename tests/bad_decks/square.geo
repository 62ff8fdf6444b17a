// A square of water, for the decks beside it.
DefineConstant[ length = {1, Name "length"} ];
Point(1) = {0, 0, 0, length/4};
Point(2) = {length, 0, 0, length/4};
Point(3) = {length, length, 0, length/4};
Point(4) = {0, length, 0, length/4};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("water") = {1};
Physical Curve("inflow") = {3};
Physical Curve("outflow") = {1};
Physical Curve("sides") = {2, 4};
