# Sketch of six points in the plane with six distances and three angles
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-6.1.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 306,314 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.10cm,8.32cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-6.1.'.format
data = 'figure-6.1.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 81 mm x 83 mm
set label 'hexagon-of-three-angles' at screen 0.50000,0.96393 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.50000,0.00842 center font ',7' tc rgb '#606060' noenhanced front
set label 'P1' at screen 0.17576,0.08662 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.72388,0.08662 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.97241,0.36764 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.83060,0.76416 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.36314,0.87729 center font ',7' tc rgb '#202020' noenhanced front
set label 'P6' at screen 0.02759,0.50353 center font ',7' tc rgb '#202020' noenhanced front
set label 'a1' at screen 0.24227,0.18234 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'a2' at screen 0.85734,0.39110 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'a3' at screen 0.39553,0.77313 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'h2' at screen 0.80013,0.26527 center font ',7' tc rgb '#606060' noenhanced front
set label 'h3' at screen 0.90216,0.56824 center font ',7' tc rgb '#606060' noenhanced front
set label 'h6' at screen 0.15463,0.31425 center font ',7' tc rgb '#606060' noenhanced front
set label 'h4' at screen 0.59496,0.81964 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5' at screen 0.19103,0.69250 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1' at screen 0.44982,0.13511 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.03006; set tmargin at screen 0.93387
set xrange [-1.08776885:4.68980348]; set yrange [-0.505537579:4.9235027]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 1 using 1:2 with lines lw 0.6 lc rgb '#D55E00', \
  data index 2 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
