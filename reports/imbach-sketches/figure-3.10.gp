# Sketches of the disulfide molecule and of the icosahedron
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-3.10.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,541 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,14.32cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-3.10.'.format
data = 'figure-3.10.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 143 mm
set label '' at screen 0.52976,0.97905 center font ',8' tc rgb '#202020' noenhanced front
set label 'disulfide-distances' at screen 0.02619,0.73020 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.52976,0.48624 center font ',7' tc rgb '#606060' noenhanced front
set label 'NA' at screen 0.15676,0.81936 center font ',7' tc rgb '#202020' noenhanced front
set label 'CaA' at screen 0.52019,0.79090 center font ',7' tc rgb '#202020' noenhanced front
set label 'CbA' at screen 0.96446,0.91203 center font ',7' tc rgb '#202020' noenhanced front
set label 'SA' at screen 0.59313,0.94753 center font ',7' tc rgb '#202020' noenhanced front
set label 'SB' at screen 0.20577,0.89205 center font ',7' tc rgb '#202020' noenhanced front
set label 'CbB' at screen 0.82850,0.51048 center font ',7' tc rgb '#202020' noenhanced front
set label 'CaB' at screen 0.31437,0.55629 center font ',7' tc rgb '#202020' noenhanced front
set label 'CB' at screen 0.10494,0.72609 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06548; set rmargin at screen 0.99405
set bmargin at screen 0.49882; set tmargin at screen 0.96158
set xrange [-0.392051667:2.77835383]; set yrange [-1.78488051:0.908039507]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 1 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 2 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 3 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 4 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 5 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 6 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
set label 'icosahedron' at screen 0.02619,0.25115 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front

# line 2, column 1
set label '' at screen 0.52976,0.00489 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.40057,0.38572 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.79047,0.44656 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.38582,0.47293 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.10288,0.29557 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.25704,0.29038 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.37746,0.12759 center font ',7' tc rgb '#202020' noenhanced front
set label 'P6' at screen 0.78512,0.21399 center font ',7' tc rgb '#202020' noenhanced front
set label 'P7' at screen 0.95664,0.20896 center font ',7' tc rgb '#202020' noenhanced front
set label 'P8' at screen 0.65465,0.37585 center font ',7' tc rgb '#202020' noenhanced front
set label 'P9' at screen 0.59770,0.10135 center font ',7' tc rgb '#202020' noenhanced front
set label 'P10' at screen 0.24927,0.07433 center font ',7' tc rgb '#202020' noenhanced front
set label 'P11' at screen 0.70903,0.02724 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06548; set rmargin at screen 0.99405
set bmargin at screen 0.01746; set tmargin at screen 0.48485
set xrange [-0.878060311:1.36182488]; set yrange [-1.47371106:0.447823117]
set border 0; unset xtics; unset ytics
plot data index 10 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 11 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 12 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 13 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 14 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 15 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 16 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 17 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 18 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 19 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
