// Channel, cylinder and elastic flag of the benchmark of Turek and Hron (Lect. Notes Comput. Sci. Eng. 53 (2006)
// 371-385): 2.5 x 0.41 m, cylinder of radius 0.05 m at (0.2, 0.2), flag of 0.35 x 0.02 m that ends at A = (0.6, 0.2).
// The flag begins where its sides meet the cylinder.
DefineConstant[ size = {0.022, Name "size"} ];   // of cells beside cylinder and flag, m; all scale with it
DefineConstant[ water = {1, Name "water"} ];    // 0: the flag alone
DefineConstant[ solid = {1, Name "solid"} ];    // 0: the water alone
near = size/4;      // on cylinder and flag
x0 = 0.2; y0 = 0.2; r = 0.05; h = 0.01; end = 0.6;
root = x0 + Sqrt(r*r - h*h);

Point(1) = {0, 0, 0, size};
Point(2) = {2.5, 0, 0, 5*size};
Point(3) = {2.5, 0.41, 0, 5*size};
Point(4) = {0, 0.41, 0, size};
Point(5) = {x0, y0, 0, near};
Point(6) = {x0 - r, y0, 0, near};
Point(7) = {root, y0 - h, 0, near/2};
Point(8) = {root, y0 + h, 0, near/2};
Point(9) = {end, y0 - h, 0, near/2};
Point(10) = {end, y0 + h, 0, near/2};
Point(11) = {end, y0, 0, near/2};
Point(12) = {x0 + r, y0, 0, near/2};
Point(13) = {1, 0, 0, size};
Point(14) = {1, 0.41, 0, size};

Line(1) = {1, 13};
Line(2) = {2, 3};
Line(3) = {14, 4};
Line(4) = {4, 1};
Circle(5) = {8, 5, 6};
Circle(6) = {6, 5, 7};
Circle(7) = {7, 5, 12};
Circle(8) = {12, 5, 8};
Line(9) = {7, 9};
Line(10) = {9, 11};
Line(11) = {11, 10};
Line(12) = {10, 8};
Line(13) = {13, 2};
Line(14) = {3, 14};

Curve Loop(1) = {1, 13, 2, 14, 3, 4};
Curve Loop(2) = {5, 6, 9, 10, 11, 12};
Curve Loop(3) = {7, 8, -12, -11, -10, -9};
If (water)
  Plane Surface(1) = {1, 2};
  Physical Surface("water") = {1};
  Physical Curve("inflow") = {4};
  Physical Curve("outflow") = {2};
  Physical Curve("walls") = {1, 13, 14, 3};
  Physical Curve("cylinder") = {5, 6};
  Physical Curve("body") = {5, 6, 9, 10, 11, 12}; // what the water touches
EndIf
If (solid)
  Plane Surface(2) = {3};
  Physical Surface("flag") = {2};
  Physical Curve("root") = {7, 8};
EndIf
Physical Curve("skin") = {9, 10, 11, 12}; // of the flag
Physical Point("A") = {11};
