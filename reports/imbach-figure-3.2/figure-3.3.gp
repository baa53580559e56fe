# The path of the sketch, which crosses t = 1 four times
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-3.3.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,314 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,8.31cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-3.3.'.format
data = 'figure-3.3.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 83 mm
set arrow from screen 0.41205,0.20686 to screen 0.41919,0.19531 nohead lw 0.5 lc rgb '#505050'
set label '−0.5' at screen 0.42395,0.18761 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.52928,0.22972 to screen 0.53642,0.21818 nohead lw 0.5 lc rgb '#505050'
set label '0.0' at screen 0.54118,0.21048 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.64650,0.25259 to screen 0.65364,0.24105 nohead lw 0.5 lc rgb '#505050'
set label '0.5' at screen 0.65841,0.23335 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.76373,0.27546 to screen 0.77087,0.26391 nohead lw 0.5 lc rgb '#505050'
set label '1.0' at screen 0.77563,0.25622 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.88095,0.29833 to screen 0.88810,0.28678 nohead lw 0.5 lc rgb '#505050'
set label '1.5' at screen 0.89286,0.27908 left font ',7' tc rgb '#202020' noenhanced front
set label 'P4_y' at screen 0.70603,0.18332 left font ',8' tc rgb '#202020' noenhanced front
set arrow from screen 0.41205,0.20686 to screen 0.40491,0.19531 nohead lw 0.5 lc rgb '#505050'
set label '−1.0' at screen 0.40015,0.18761 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.33880,0.24345 to screen 0.33166,0.23191 nohead lw 0.5 lc rgb '#505050'
set label '−0.5' at screen 0.32689,0.22421 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.26555,0.28005 to screen 0.25841,0.26850 nohead lw 0.5 lc rgb '#505050'
set label '0.0' at screen 0.25364,0.26081 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.19230,0.31664 to screen 0.18516,0.30510 nohead lw 0.5 lc rgb '#505050'
set label '0.5' at screen 0.18039,0.29740 right font ',7' tc rgb '#202020' noenhanced front
set label 'P5_z' at screen 0.20603,0.21077 right font ',8' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.35343 to screen 0.10905,0.35343 nohead lw 0.5 lc rgb '#505050'
set label '0' at screen 0.10238,0.35343 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.60099 to screen 0.10905,0.60099 nohead lw 0.5 lc rgb '#505050'
set label '1' at screen 0.10238,0.60099 right font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.84856 to screen 0.10905,0.84856 nohead lw 0.5 lc rgb '#505050'
set label '2' at screen 0.10238,0.84856 right font ',7' tc rgb '#202020' noenhanced front
set label 't' at screen 0.03571,0.61886 right font ',8' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.07697 to screen 0.22619,0.07697 nohead lc rgb '#0072B2' dt 1 lw 1.1
set label 'whole path' at screen 0.24405,0.07697 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.11905,0.03367 to screen 0.22619,0.03367 nohead lc rgb '#D55E00' dt 1 lw 3.2
set label 'to the first crossing' at screen 0.24405,0.03367 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.11905; set rmargin at screen 0.88095
set bmargin at screen 0.20686; set tmargin at screen 0.97595
set xrange [-0.529919264:0.848048096]; set yrange [0:1.37687185]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.07 noborder lc rgb '#000000', \
  data index 1 using 1:2 with lines lw 0.5 lc rgb '#A0A0A0', \
  data index 2 using 1:2 with filledcurves closed fs transparent solid 0.07 noborder lc rgb '#E69F00', \
  data index 3 using 1:2 with lines lw 0.5 lc rgb '#A0A0A0', \
  data index 4 using 1:2 with lines lw 0.5 lc rgb '#505050', \
  data index 5 using 1:2 with lines lw 0.5 dt 3 lc rgb '#505050', \
  data index 6 using 1:2 with lines lc rgb '#D55E00' dt 1 lw 3.2, \
  data index 7 using 1:2 with lines lc rgb '#0072B2' dt 1 lw 1.1, \
  data index 8 using 1:2 with points pt 5 ps 0.6 lc rgb '#202020', \
  data index 9 using 1:2 with points pt 7 ps 0.6 lc rgb '#202020'
unset label; unset arrow
unset multiplot
unset output
