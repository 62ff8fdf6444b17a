// A channel of 8 x 1 m with a leaflet, a line of 0.5 m that stands on the lower wall at x = 1 m and ends freely.
// All cells scale with `size`; `tip` makes those at the free end smaller.
DefineConstant[ size = {0.025, Name "size"} ]; // on the leaflet, m
DefineConstant[ tip = {size, Name "tip"} ];   // at its free end, m

Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {8, 0, 0};
Point(4) = {8, 1, 0};
Point(5) = {0, 1, 0};
Point(6) = {1, 0.5, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Line(6) = {2, 6};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Curve{6} In Surface{1};

Field[1] = Distance;
Field[1].CurvesList = {6};
Field[1].NumPointsPerCurve = 200;
Field[2] = MathEval; // away from the leaflet
Field[2].F = Sprintf("%g*Min(1 + 8*F1, 6)", size);
Field[3] = Box; // where the jet over the tip goes
Field[3].XMin = 0.8;
Field[3].XMax = 2.4;
Field[3].YMin = 0;
Field[3].YMax = 1;
Field[3].VIn = 3*size;
Field[3].VOut = 6*size;
Field[3].Thickness = 0.8;
Field[4] = Distance;
Field[4].PointsList = {6};
Field[5] = MathEval;
Field[5].F = Sprintf("%g + 0.15*F4", tip);
Field[6] = Distance;
Field[6].CurvesList = {5};
Field[6].NumPointsPerCurve = 200;
Field[7] = MathEval; // linear cells of height h lose h^2 of the inflow's parabola
Field[7].F = Sprintf("%g*(2 + 16*F6)", size);
Field[8] = Min;
Field[8].FieldsList = {2, 3, 5, 7};
Background Field = 8;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;

Physical Surface("water") = {1};
Physical Curve("leaflet") = {6};
Physical Curve("walls") = {1, 2, 4};
Physical Curve("inflow") = {5};
Physical Curve("outflow") = {3};
Physical Point("base") = {2};
Physical Point("tip") = {6};
