# Coplanarities kept
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' kept.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,283 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,7.49cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'kept.'.format
data = 'kept.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 75 mm
set arrow from screen 0.41205,0.12008 to screen 0.41919,0.10727 nohead lw 0.5 lc rgb '#505050'
set label '−0.5' at screen 0.42395,0.09873 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.64650,0.17082 to screen 0.65364,0.15801 nohead lw 0.5 lc rgb '#505050'
set label '0.0' at screen 0.65841,0.14947 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.88095,0.22156 to screen 0.88810,0.20875 nohead lw 0.5 lc rgb '#505050'
set label '0.5' at screen 0.89286,0.20021 left font ',7' tc rgb '#202020' noenhanced front
set label 'P7_y' at screen 0.70603,0.09397 left font ',8' tc rgb '#202020' noenhanced front
set arrow from screen 0.41205,0.12008 to screen 0.40491,0.10727 nohead lw 0.5 lc rgb '#505050'
set label '−0.5' at screen 0.40015,0.09873 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.26555,0.20128 to screen 0.25841,0.18847 nohead lw 0.5 lc rgb '#505050'
set label '0.0' at screen 0.25364,0.17993 right font ',7' tc rgb '#202020' noenhanced front
set label 'P7_z' at screen 0.20603,0.12443 right font ',8' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.39411 to screen 0.10905,0.39411 nohead lw 0.5 lc rgb '#505050'
set label '0.0' at screen 0.10238,0.39411 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.57917 to screen 0.10905,0.57917 nohead lw 0.5 lc rgb '#505050'
set label '0.5' at screen 0.10238,0.57917 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.76423 to screen 0.10905,0.76423 nohead lw 0.5 lc rgb '#505050'
set label '1.0' at screen 0.10238,0.76423 right font ',7' tc rgb '#202020' noenhanced front
set label 't' at screen 0.03571,0.57716 right font ',8' tc rgb '#202020' noenhanced front
set lmargin at screen 0.11905; set rmargin at screen 0.88095
set bmargin at screen 0.12008; set tmargin at screen 0.97332
set xrange [-0.529919264:0.848048096]; set yrange [0:1.37687185]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.07 noborder lc rgb '#000000', \
  data index 1 using 1:2 with lines lw 0.5 lc rgb '#A0A0A0', \
  data index 2 using 1:2 with filledcurves closed fs transparent solid 0.07 noborder lc rgb '#E69F00', \
  data index 3 using 1:2 with lines lw 0.5 lc rgb '#A0A0A0', \
  data index 4 using 1:2 with lines lw 0.5 lc rgb '#505050', \
  data index 5 using 1:2 with lines lw 0.5 dt 3 lc rgb '#505050', \
  data index 6 using 1:2 with lines lc rgb '#0072B2' dt 1 lw 1.1, \
  data index 7 using 1:2 with points pt 5 ps 0.6 lc rgb '#202020', \
  data index 8 using 1:2 with points pt 7 ps 0.6 lc rgb '#202020'
unset label; unset arrow
unset multiplot
unset output
