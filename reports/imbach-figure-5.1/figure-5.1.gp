# Coplanarities kept: where the path meets flat figures branches cross
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-5.1.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,283 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,7.49cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-5.1.'.format
data = 'figure-5.1.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 75 mm
set arrow from screen 0.41205,0.12008 to screen 0.41919,0.10727 nohead lw 0.5 lc rgb '#505050'
set label '−1.0' at screen 0.42395,0.09873 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.50583,0.14038 to screen 0.51297,0.12757 nohead lw 0.5 lc rgb '#505050'
set label '−0.5' at screen 0.51774,0.11903 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.59961,0.16067 to screen 0.60675,0.14786 nohead lw 0.5 lc rgb '#505050'
set label '0.0' at screen 0.61152,0.13932 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.69339,0.18097 to screen 0.70053,0.16816 nohead lw 0.5 lc rgb '#505050'
set label '0.5' at screen 0.70530,0.15962 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.78717,0.20126 to screen 0.79431,0.18845 nohead lw 0.5 lc rgb '#505050'
set label '1.0' at screen 0.79908,0.17992 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.88095,0.22156 to screen 0.88810,0.20875 nohead lw 0.5 lc rgb '#505050'
set label '1.5' at screen 0.89286,0.20021 left font ',7' tc rgb '#202020' noenhanced front
set label 'P5_y' at screen 0.70603,0.09397 left font ',8' tc rgb '#202020' noenhanced front
set arrow from screen 0.41205,0.12008 to screen 0.40491,0.10727 nohead lw 0.5 lc rgb '#505050'
set label '−2' at screen 0.40015,0.09873 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.33880,0.16068 to screen 0.33166,0.14787 nohead lw 0.5 lc rgb '#505050'
set label '−1' at screen 0.32689,0.13933 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.26555,0.20128 to screen 0.25841,0.18847 nohead lw 0.5 lc rgb '#505050'
set label '0' at screen 0.25364,0.17993 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.19230,0.24188 to screen 0.18516,0.22907 nohead lw 0.5 lc rgb '#505050'
set label '1' at screen 0.18039,0.22053 right font ',7' tc rgb '#202020' noenhanced front
set label 'P5_z' at screen 0.20603,0.12443 right font ',8' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.37600 to screen 0.10905,0.37600 nohead lw 0.5 lc rgb '#505050'
set label '0.0' at screen 0.10238,0.37600 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.57843 to screen 0.10905,0.57843 nohead lw 0.5 lc rgb '#505050'
set label '0.5' at screen 0.10238,0.57843 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.78087 to screen 0.10905,0.78087 nohead lw 0.5 lc rgb '#505050'
set label '1.0' at screen 0.10238,0.78087 right font ',7' tc rgb '#202020' noenhanced front
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
  data index 7 using 1:2 with points pt 7 ps 0.75 lc rgb 'white', \
  data index 8 using 1:2 with points pt 6 ps 0.75 lw 1.2 lc rgb '#D55E00', \
  data index 9 using 1:2 with points pt 5 ps 0.6 lc rgb '#202020', \
  data index 10 using 1:2 with points pt 7 ps 0.6 lc rgb '#202020'
unset label; unset arrow
unset multiplot
unset output
