// A lead-in of 100 m and an array of 300 m behind it, 30 degrees off -y, which meet in the node "joint".
//   gmsh -1 two_cables.geo -o two_cables.msh
c = Cos(Pi / 6); s = Sin(Pi / 6);
Point(1) = {0, 0, 0}; Point(2) = {100 * s, -100 * c, 0}; Point(3) = {400 * s, -400 * c, 0};
Line(1) = {1, 2}; Transfinite Curve{1} = 6;
Line(2) = {2, 3}; Transfinite Curve{2} = 16;
Physical Curve("lead-in") = {1}; Physical Curve("array") = {2};
Physical Point("tow-point") = {1}; Physical Point("joint") = {2}; Physical Point("tail") = {3};
