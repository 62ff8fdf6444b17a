// A channel of 10 m by 2 m in two named parts that share their nodes, as from a CAD fragment; "water" names both.
//   gmsh -2 two_waters.geo -o two_waters.msh
size = 0.7;
Point(1) = {0, 0, 0, size}; Point(2) = {5, 0, 0, size}; Point(3) = {5, 2, 0, size};
Point(4) = {0, 2, 0, size}; Point(5) = {10, 0, 0, size}; Point(6) = {10, 2, 0, size};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {2, 5}; Line(6) = {5, 6}; Line(7) = {6, 3};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, -2}; Plane Surface(2) = {2};
Physical Surface("near") = {1}; Physical Surface("far") = {2}; Physical Surface("water") = {1, 2};
Physical Curve("inflow") = {4}; Physical Curve("outflow") = {6}; Physical Curve("walls") = {1, 3, 5, 7};
