# All boxes of LP reduction, above, and of interval Newton, below
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' boxes.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,288 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,7.61cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'boxes.'.format
data = 'boxes.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 76 mm

# LP reduction / ellipses-four
set label 'LP reduction' at screen 0.01149,0.73325 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front
set label 'ellipses-four' at screen 0.14138,0.92773 center font ',8' tc rgb '#202020' noenhanced front
set label '7 boxes, 4 roots' at screen 0.14138,0.49212 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.21379
set bmargin at screen 0.56767; set tmargin at screen 0.89882
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

# LP reduction / circle-parabola-two
set label 'circle-parabola-two' at screen 0.33506,0.92773 center font ',8' tc rgb '#202020' noenhanced front
set label '3 boxes, 2 roots' at screen 0.33506,0.49212 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.26264; set rmargin at screen 0.40747
set bmargin at screen 0.56767; set tmargin at screen 0.89882
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

# LP reduction / circles-nearly-tangent-two
set label 'circles-nearly-' at screen 0.52874,0.96978 center font ',8' tc rgb '#202020' noenhanced front
set label 'tangent-two' at screen 0.52874,0.92773 center font ',8' tc rgb '#202020' noenhanced front
set label '7 boxes, 2 roots' at screen 0.52874,0.49212 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.45632; set rmargin at screen 0.60115
set bmargin at screen 0.56767; set tmargin at screen 0.89882
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y ''
set ytics (-3, 0, 3)
plot data index 12 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 13 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 14 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 15 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 16 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 17 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# LP reduction / circle-parabola-tangent-crossing
set label 'circle-parabola-' at screen 0.72241,0.96978 center font ',8' tc rgb '#202020' noenhanced front
set label 'tangent-crossing' at screen 0.72241,0.92773 center font ',8' tc rgb '#202020' noenhanced front
set label '53 boxes, 2 roots' at screen 0.72241,0.49212 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.65000; set rmargin at screen 0.79483
set bmargin at screen 0.56767; set tmargin at screen 0.89882
set xrange [-2:2]
set format x '%.3g'
set xtics (-2, 0, 2)
set yrange [-2:2]
set format y '%.3g'
set ytics (-2, 0, 2)
plot data index 18 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 19 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 20 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 21 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 22 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 23 using 1:2 with points pt 13 ps 0.6 lc rgb '#E69F00', \
  data index 24 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# LP reduction / ellipse-hyperbola-apart
set label 'ellipse-' at screen 0.91609,0.96978 center font ',8' tc rgb '#202020' noenhanced front
set label 'hyperbola-apart' at screen 0.91609,0.92773 center font ',8' tc rgb '#202020' noenhanced front
set label '1 box, 0 roots' at screen 0.91609,0.49212 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.84368; set rmargin at screen 0.98851
set bmargin at screen 0.56767; set tmargin at screen 0.89882
set xrange [-4:4]
set format x '%.3g'
set xtics (-4, 0, 4)
set yrange [-4:4]
set format y '%.3g'
set ytics (-4, 0, 4)
plot data index 25 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 26 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#D2D2D2', \
  data index 27 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 28 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 29 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 30 using 1:2 with lines lw 0.7 lc rgb '#D55E00'
unset label; unset arrow

# interval Newton / ellipses-four
set label 'interval Newton' at screen 0.01149,0.27070 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front
set label '23 boxes, 4 roots' at screen 0.14138,0.02957 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.21379
set bmargin at screen 0.10512; set tmargin at screen 0.43627
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y '%.3g'
set ytics (-3, 0, 3)
plot data index 31 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 32 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#D2D2D2', \
  data index 33 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#A9DCC6', \
  data index 34 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 35 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 36 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 37 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 38 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# interval Newton / circle-parabola-two
set label '27 boxes, 2 roots' at screen 0.33506,0.02957 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.26264; set rmargin at screen 0.40747
set bmargin at screen 0.10512; set tmargin at screen 0.43627
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y ''
set ytics (-3, 0, 3)
plot data index 39 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 40 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#D2D2D2', \
  data index 41 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 42 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 43 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 44 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 45 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# interval Newton / circles-nearly-tangent-two
set label '31 boxes, 2 roots' at screen 0.52874,0.02957 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.45632; set rmargin at screen 0.60115
set bmargin at screen 0.10512; set tmargin at screen 0.43627
set xrange [-3:3]
set format x '%.3g'
set xtics (-3, 0, 3)
set yrange [-3:3]
set format y ''
set ytics (-3, 0, 3)
plot data index 46 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 47 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#D2D2D2', \
  data index 48 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 49 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 50 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 51 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 52 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# interval Newton / circle-parabola-tangent-crossing
set label '171 boxes, 2 roots' at screen 0.72241,0.02957 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.65000; set rmargin at screen 0.79483
set bmargin at screen 0.10512; set tmargin at screen 0.43627
set xrange [-2:2]
set format x '%.3g'
set xtics (-2, 0, 2)
set yrange [-2:2]
set format y '%.3g'
set ytics (-2, 0, 2)
plot data index 53 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 54 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#D2D2D2', \
  data index 55 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 56 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 57 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 58 using 1:2 with lines lw 0.7 lc rgb '#D55E00', \
  data index 59 using 1:2 with points pt 13 ps 0.6 lc rgb '#E69F00', \
  data index 60 using 1:2 with points pt 7 ps 0.4 lc rgb '#000000'
unset label; unset arrow

# interval Newton / ellipse-hyperbola-apart
set label '39 boxes, 0 roots' at screen 0.91609,0.02957 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.84368; set rmargin at screen 0.98851
set bmargin at screen 0.10512; set tmargin at screen 0.43627
set xrange [-4:4]
set format x '%.3g'
set xtics (-4, 0, 4)
set yrange [-4:4]
set format y '%.3g'
set ytics (-4, 0, 4)
plot data index 61 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E3EFF8', \
  data index 62 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#D2D2D2', \
  data index 63 using 1:2 with lines lw 0.35 lc rgb '#7FB3D9', \
  data index 64 using 1:2 with lines lw 0.35 lc rgb '#505050', \
  data index 65 using 1:2 with lines lw 0.7 lc rgb '#0072B2', \
  data index 66 using 1:2 with lines lw 0.7 lc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
