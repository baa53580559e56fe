# The plan as a graph
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-4.1.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 380,399 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 10.05cm,10.56cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-4.1.'.format
data = 'figure-4.1.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 100.45499999999996 mm x 106 mm
set label 'P0 (1)' at screen 0.55953,0.96592 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1 (2)' at screen 0.51648,0.80500 center font ',7' tc rgb '#202020' noenhanced front
set label 'h0' at screen 0.53801,0.88546 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2 (3)' at screen 0.54509,0.63083 center font ',7' tc rgb '#202020' noenhanced front
set label 'h1' at screen 0.53079,0.71792 center font ',7' tc rgb '#202020' noenhanced front
set label 'k0' at screen 0.64474,0.71792 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'P3 (4)' at screen 0.43496,0.45666 center font ',7' tc rgb '#202020' noenhanced front
set label 'h2' at screen 0.52753,0.54375 center font ',7' tc rgb '#202020' noenhanced front
set label 'h3' at screen 0.35202,0.54375 center font ',7' tc rgb '#202020' noenhanced front
set label 'k1' at screen 0.43977,0.54375 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'P4 (5)' at screen 0.40895,0.28249 center font ',7' tc rgb '#202020' noenhanced front
set label 'h4' at screen 0.42196,0.36958 center font ',7' tc rgb '#202020' noenhanced front
set label 'h8' at screen 0.55124,0.36958 center font ',7' tc rgb '#202020' noenhanced front
set label 'k2' at screen 0.32274,0.36958 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'P5 (6)' at screen 0.50044,0.12157 center font ',7' tc rgb '#202020' noenhanced front
set label 'h5' at screen 0.45874,0.20203 center font ',7' tc rgb '#202020' noenhanced front
set label 'h7' at screen 0.56604,0.20203 center font ',7' tc rgb '#202020' noenhanced front
set label 'h6' at screen 0.70830,0.20203 center font ',7' tc rgb '#202020' noenhanced front
set label 'coplanar P0 P1 P2 P3' at screen 0.83499,0.03408 center font ',7' tc rgb '#606060' noenhanced front
set label 'coplanar P0 P3 P4 P5' at screen 0.16501,0.03408 center font ',7' tc rgb '#606060' noenhanced front
set label 'coplanar P1 P2 P4 P5' at screen 0.50000,0.03408 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00000; set rmargin at screen 1.00000
set bmargin at screen 0.00000; set tmargin at screen 1.00000
set xrange [0:100.45499999999996]; set yrange [0:105.64355178590941]
unset border; unset tics; unset key
plot \
  data index 0 using 1:2 with lines lw 0.6 dt 1 lc rgb '#505050', \
  data index 1 using 1:2 with lines lw 0.9 dt 1 lc rgb '#D55E00', \
  data index 2 using 1:2 with lines lw 0.5 dt (10,6) lc rgb '#808080', \
  data index 3 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#505050', \
  data index 4 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#D55E00', \
  data index 5 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EAF2F8', \
  data index 6 using 1:2 with lines lw 0.9 dt 1 lc rgb '#000000', \
  data index 7 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#FBEBDD', \
  data index 8 using 1:2 with lines lw 0.9 dt 1 lc rgb '#D55E00', \
  data index 9 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#FFFFFF', \
  data index 10 using 1:2 with lines lw 0.5 dt (10,6) lc rgb '#808080', \
  data index 11 using 1:2 with lines lw 0.4 lc rgb '#000000'
unset multiplot
unset output
