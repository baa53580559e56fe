# All boxes of LP reduction on sixteen pairs of conics
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' boxes.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,738 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,19.52cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'boxes.'.format
data = 'boxes.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 195 mm

# LP reduction / ellipses-four
set label 'ellipses-four' at screen 0.15069,0.98821 center font ',8' tc rgb '#202020' noenhanced front
set label '7 boxes, 4 roots' at screen 0.15069,0.77139 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.05194; set rmargin at screen 0.24945
set bmargin at screen 0.80086; set tmargin at screen 0.97694
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y '%.3g'
set ytics (-3, 0, 3)
plot data index 0 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 1 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 2 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 3 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 4 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 5 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# LP reduction / circle-hyperbola-four
set label 'circle-hyperbola-four' at screen 0.39705,0.98821 center font ',8' tc rgb '#202020' noenhanced front
set label '7 boxes, 4 roots' at screen 0.39705,0.77139 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.29830; set rmargin at screen 0.49580
set bmargin at screen 0.80086; set tmargin at screen 0.97694
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y ''
set ytics (-3, 0, 3)
plot data index 6 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 7 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 8 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 9 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 10 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 11 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# LP reduction / parabolas-four
set label 'parabolas-four' at screen 0.64340,0.98821 center font ',8' tc rgb '#202020' noenhanced front
set label '7 boxes, 4 roots' at screen 0.64340,0.77139 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.54465; set rmargin at screen 0.74215
set bmargin at screen 0.80086; set tmargin at screen 0.97694
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y ''
set ytics (-3, 0, 3)
plot data index 12 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 13 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#A9DCC6', \
  data index 14 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 15 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 16 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 17 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 18 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# LP reduction / hyperbolas-two
set label 'hyperbolas-two' at screen 0.88975,0.98821 center font ',8' tc rgb '#202020' noenhanced front
set label '3 boxes, 2 roots' at screen 0.88975,0.77139 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.79100; set rmargin at screen 0.98851
set bmargin at screen 0.80086; set tmargin at screen 0.97694
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y ''
set ytics (-3, 0, 3)
plot data index 19 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 20 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 21 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 22 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 23 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 24 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# LP reduction / circle-parabola
set label 'circle-parabola' at screen 0.15069,0.74039 center font ',8' tc rgb '#202020' noenhanced front
set label '3 boxes, 9 reductions, 2 roots' at screen 0.15069,0.54936 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.05194; set rmargin at screen 0.24945
set bmargin at screen 0.57882; set tmargin at screen 0.72912
set xrange [-2:2]
set format x '%.3g'
set xtics (-2, 0, 2)
set yrange [-1.4142135623730951:2]
set format y '%.3g'
set ytics (-1.4142135623730951, 0.2928932188134524, 2)
plot data index 25 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 26 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 27 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 28 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 29 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 30 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# LP reduction / circle-parabola-two
set label 'circle-parabola-two' at screen 0.39705,0.74039 center font ',8' tc rgb '#202020' noenhanced front
set label '3 boxes, 2 roots' at screen 0.39705,0.52357 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.29830; set rmargin at screen 0.49580
set bmargin at screen 0.55303; set tmargin at screen 0.72912
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y '%.3g'
set ytics (-3, 0, 3)
plot data index 31 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 32 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 33 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 34 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 35 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 36 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# LP reduction / circles-nearly-tangent-two
set label 'circles-nearly-tangent-two' at screen 0.64340,0.74039 center font ',8' tc rgb '#202020' noenhanced front
set label '7 boxes, 2 roots' at screen 0.64340,0.52357 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.54465; set rmargin at screen 0.74215
set bmargin at screen 0.55303; set tmargin at screen 0.72912
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y ''
set ytics (-3, 0, 3)
plot data index 37 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 38 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 39 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 40 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 41 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 42 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# LP reduction / ellipses-nearly-tangent
set label 'ellipses-nearly-tangent' at screen 0.88975,0.74039 center font ',8' tc rgb '#202020' noenhanced front
set label '5 boxes, 2 roots' at screen 0.88975,0.52357 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.79100; set rmargin at screen 0.98851
set bmargin at screen 0.55303; set tmargin at screen 0.72912
set xrange [-3:7]
set format x '%.3g'
set xtics (-3, 2, 7)
set yrange [-3:7]
set format y '%.3g'
set ytics (-3, 2, 7)
plot data index 43 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 44 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 45 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 46 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 47 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 48 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# LP reduction / circles-tangent-outside
set label 'circles-tangent-outside' at screen 0.15069,0.47617 center font ',8' tc rgb '#202020' noenhanced front
set label '259 boxes, 0 roots' at screen 0.15069,0.25935 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.05194; set rmargin at screen 0.24945
set bmargin at screen 0.28881; set tmargin at screen 0.46490
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y '%.3g'
set ytics (-3, 0, 3)
plot data index 49 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 50 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 51 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 52 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 53 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 54 using 1:2 with points pt 13 ps 0.6 lc rgb '#E69F00'
unset label; unset arrow

# LP reduction / circles-tangent-inside
set label 'circles-tangent-inside' at screen 0.39705,0.47617 center font ',8' tc rgb '#202020' noenhanced front
set label '259 boxes, 0 roots' at screen 0.39705,0.25935 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.29830; set rmargin at screen 0.49580
set bmargin at screen 0.28881; set tmargin at screen 0.46490
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y ''
set ytics (-3, 0, 3)
plot data index 55 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 56 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 57 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 58 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 59 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 60 using 1:2 with points pt 13 ps 0.6 lc rgb '#E69F00'
unset label; unset arrow

# LP reduction / ellipse-circle-tangent-twice
set label 'ellipse-circle-' at screen 0.64340,0.49257 center font ',8' tc rgb '#202020' noenhanced front
set label 'tangent-twice' at screen 0.64340,0.47617 center font ',8' tc rgb '#202020' noenhanced front
set label '263 boxes, 0 roots' at screen 0.64340,0.25935 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.54465; set rmargin at screen 0.74215
set bmargin at screen 0.28881; set tmargin at screen 0.46490
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y ''
set ytics (-3, 0, 3)
plot data index 61 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 62 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#D2D2D2', \
  data index 63 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 64 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 65 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 66 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 67 using 1:2 with points pt 13 ps 0.6 lc rgb '#E69F00'
unset label; unset arrow

# LP reduction / circle-parabola-tangent-crossing
set label 'circle-parabola-' at screen 0.88975,0.49257 center font ',8' tc rgb '#202020' noenhanced front
set label 'tangent-crossing' at screen 0.88975,0.47617 center font ',8' tc rgb '#202020' noenhanced front
set label '53 boxes, 2 roots' at screen 0.88975,0.25935 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.79100; set rmargin at screen 0.98851
set bmargin at screen 0.28881; set tmargin at screen 0.46490
set xrange [-2:2]
set format x '%.3g'
set xtics (-2, 0, 2)
set yrange [-2:2]
set format y '%.3g'
set ytics (-2, 0, 2)
plot data index 68 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 69 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 70 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 71 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 72 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 73 using 1:2 with points pt 13 ps 0.6 lc rgb '#E69F00', \
  data index 74 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# LP reduction / circles-apart
set label 'circles-apart' at screen 0.15069,0.22835 center font ',8' tc rgb '#202020' noenhanced front
set label '1 box, 2 reductions, 0 roots' at screen 0.15069,0.01153 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.05194; set rmargin at screen 0.24945
set bmargin at screen 0.04099; set tmargin at screen 0.21708
set xrange [-4:4]
set format x '%.3g'
set xtics (-4, 0, 4)
set yrange [-4:4]
set format y '%.3g'
set ytics (-4, 0, 4)
plot data index 75 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 76 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#D2D2D2', \
  data index 77 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 78 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 79 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 80 using 1:2 with lines lw 0.7 lc rgb '#D55E00'
unset label; unset arrow

# LP reduction / ellipse-hyperbola-apart
set label 'ellipse-hyperbola-apart' at screen 0.39705,0.22835 center font ',8' tc rgb '#202020' noenhanced front
set label '1 box, 2 reductions, 0 roots' at screen 0.39705,0.01153 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.29830; set rmargin at screen 0.49580
set bmargin at screen 0.04099; set tmargin at screen 0.21708
set xrange [-4:4]
set format x '%.3g'
set xtics (-4, 0, 4)
set yrange [-4:4]
set format y ''
set ytics (-4, 0, 4)
plot data index 81 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 82 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#D2D2D2', \
  data index 83 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 84 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 85 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 86 using 1:2 with lines lw 0.7 lc rgb '#D55E00'
unset label; unset arrow

# LP reduction / circles-nested
set label 'circles-nested' at screen 0.64340,0.22835 center font ',8' tc rgb '#202020' noenhanced front
set label '1 box, 1 reduction, 0 roots' at screen 0.64340,0.01153 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.54465; set rmargin at screen 0.74215
set bmargin at screen 0.04099; set tmargin at screen 0.21708
set xrange [-2:2]
set format x '%.3g'
set xtics (-2, 0, 2)
set yrange [-2:2]
set format y '%.3g'
set ytics (-2, 0, 2)
plot data index 87 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#D2D2D2', \
  data index 88 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 89 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 90 using 1:2 with lines lw 0.7 lc rgb '#D55E00'
unset label; unset arrow

# LP reduction / parabolas-offset
set label 'parabolas-offset' at screen 0.88975,0.22835 center font ',8' tc rgb '#202020' noenhanced front
set label '1 box, 1 reduction, 0 roots' at screen 0.88975,0.01153 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.79100; set rmargin at screen 0.98851
set bmargin at screen 0.04099; set tmargin at screen 0.21708
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y '%.3g'
set ytics (-1, 0, 1)
plot data index 91 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#D2D2D2', \
  data index 92 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 93 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 94 using 1:2 with lines lw 0.7 lc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
