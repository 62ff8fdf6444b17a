// A channel of 2.2 m by .41 m with a cylinder of .1 m a little below its middle: cells of `wall` on the cylinder that grow
// by `growth` of their distance from it to `far` (and from x = .5 m on by `downstream` of the way further).
//   gmsh -2 -format msh22 -bin cylinder.geo -o cylinder.msh
// algorithm and wall make other triangulations of the same density.
DefineConstant[ wall = 0.0013, growth = 0.047, far = 0.019, downstream = 0.04, algorithm = 6 ];
Mesh.Algorithm = algorithm;
Mesh.CharacteristicLengthExtendFromBoundary = 0; Mesh.CharacteristicLengthFromPoints = 0;
radius = 0.05;
Point(1) = {0, 0, 0}; Point(2) = {2.2, 0, 0}; Point(3) = {2.2, 0.41, 0}; Point(4) = {0, 0.41, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Point(5) = {0.2, 0.2, 0};
For k In {0:3}
  Point(6 + k) = {0.2 + radius*Cos(k*Pi/2), 0.2 + radius*Sin(k*Pi/2), 0};
EndFor
For k In {0:3}
  Circle(5 + k) = {6 + k, 5, 6 + (k + 1)%4};
EndFor
Curve Loop(1) = {1, 2, 3, 4}; Curve Loop(2) = {5, 6, 7, 8}; Plane Surface(1) = {1, 2};
Field[1] = MathEval;
Field[1].F = Sprintf("%g + %g*(sqrt((x - 0.2)^2 + (y - 0.2)^2) - %g)", wall, growth, radius);
Field[2] = MathEval; Field[2].F = Sprintf("%g + %g*(x - 0.5 + abs(x - 0.5))", far, 0.5*downstream);
Field[3] = Min; Field[3].FieldsList = {1, 2};
Background Field = 3;
Physical Surface("water") = {1};
Physical Curve("inflow") = {4}; Physical Curve("outflow") = {2}; Physical Curve("walls") = {1, 3};
Physical Curve("cylinder") = {5, 6, 7, 8};
Physical Point("front") = {8}; Physical Point("rear") = {6};
