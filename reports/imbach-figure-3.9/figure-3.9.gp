# Paths of 6p7d3a2c: a cycle, one that escapes to infinity, one that ends where an angle is undefined
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-3.9.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,328 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,8.67cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-3.9.'.format
data = 'figure-3.9.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 87 mm
set arrow from screen 0.41205,0.23977 to screen 0.41919,0.22871 nohead lw 0.5 lc rgb '#505050'
set label '0.0' at screen 0.42395,0.22133 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.52928,0.26169 to screen 0.53642,0.25062 nohead lw 0.5 lc rgb '#505050'
set label '0.5' at screen 0.54118,0.24325 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.64650,0.28361 to screen 0.65364,0.27254 nohead lw 0.5 lc rgb '#505050'
set label '1.0' at screen 0.65841,0.26516 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.76373,0.30553 to screen 0.77087,0.29446 nohead lw 0.5 lc rgb '#505050'
set label '1.5' at screen 0.77563,0.28708 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.88095,0.32745 to screen 0.88810,0.31638 nohead lw 0.5 lc rgb '#505050'
set label '2.0' at screen 0.89286,0.30900 left font ',7' tc rgb '#202020' noenhanced front
set label 'P4_x' at screen 0.70603,0.21721 left font ',8' tc rgb '#202020' noenhanced front
set arrow from screen 0.41205,0.23977 to screen 0.40491,0.22871 nohead lw 0.5 lc rgb '#505050'
set label '0' at screen 0.40015,0.22133 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.31438,0.28654 to screen 0.30724,0.27547 nohead lw 0.5 lc rgb '#505050'
set label '2' at screen 0.30248,0.26810 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.21672,0.33331 to screen 0.20957,0.32224 nohead lw 0.5 lc rgb '#505050'
set label '4' at screen 0.20481,0.31487 right font ',7' tc rgb '#202020' noenhanced front
set label 'P3_y' at screen 0.20603,0.24353 right font ',8' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.49747 to screen 0.10905,0.49747 nohead lw 0.5 lc rgb '#505050'
set label '0.0' at screen 0.10238,0.49747 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.67955 to screen 0.10905,0.67955 nohead lw 0.5 lc rgb '#505050'
set label '0.5' at screen 0.10238,0.67955 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.86162 to screen 0.10905,0.86162 nohead lw 0.5 lc rgb '#505050'
set label '1.0' at screen 0.10238,0.86162 right font ',7' tc rgb '#202020' noenhanced front
set label 't' at screen 0.03571,0.63468 right font ',8' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.11527 to screen 0.22619,0.11527 nohead lc rgb '#0072B2' dt 1 lw 1.1
set label 'a cycle' at screen 0.24405,0.11527 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.07378 to screen 0.22619,0.07378 nohead lc rgb '#D55E00' dt 2 lw 1.1
set label 'to infinity' at screen 0.24405,0.07378 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.03228 to screen 0.22619,0.03228 nohead lc rgb '#009E73' dt 3 lw 1.1
set label 'to an undefined point' at screen 0.24405,0.03228 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.11905; set rmargin at screen 0.88095
set bmargin at screen 0.23977; set tmargin at screen 0.97695
set xrange [-0.529919264:0.848048096]; set yrange [0:1.37687185]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.07 noborder lc rgb '#000000', \
  data index 1 using 1:2 with lines lw 0.5 lc rgb '#A0A0A0', \
  data index 2 using 1:2 with filledcurves closed fs transparent solid 0.07 noborder lc rgb '#E69F00', \
  data index 3 using 1:2 with lines lw 0.5 lc rgb '#A0A0A0', \
  data index 4 using 1:2 with lines lw 0.5 lc rgb '#505050', \
  data index 5 using 1:2 with lines lw 0.5 dt 3 lc rgb '#505050', \
  data index 6 using 1:2 with lines lc rgb '#0072B2' dt 1 lw 1.1, \
  data index 7 using 1:2 with lines lc rgb '#D55E00' dt 2 lw 1.1, \
  data index 8 using 1:2 with lines lc rgb '#009E73' dt 3 lw 1.1, \
  data index 9 using 1:2 with points pt 5 ps 0.6 lc rgb '#202020', \
  data index 10 using 1:2 with points pt 7 ps 0.6 lc rgb '#202020'
unset label; unset arrow
unset multiplot
unset output
