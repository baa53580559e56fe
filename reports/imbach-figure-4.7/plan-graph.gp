# (b) The plan as a graph
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' plan-graph.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,324 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,8.58cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'plan-graph.'.format
data = 'plan-graph.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 86 mm
set label 'P0 (1)' at screen 0.54358,0.95804 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1 (2)' at screen 0.42251,0.75991 center font ',7' tc rgb '#202020' noenhanced front
set label 'h0' at screen 0.46987,0.85897 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2 (3)' at screen 0.42026,0.56177 center font ',7' tc rgb '#202020' noenhanced front
set label 'h1' at screen 0.48132,0.66084 center font ',7' tc rgb '#202020' noenhanced front
set label 'h2' at screen 0.40614,0.66084 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3 (4)' at screen 0.43929,0.34732 center font ',7' tc rgb '#202020' noenhanced front
set label 'h5' at screen 0.34753,0.45455 center font ',7' tc rgb '#202020' noenhanced front
set label 'h7' at screen 0.42271,0.45455 center font ',7' tc rgb '#202020' noenhanced front
set label 'k0' at screen 0.50980,0.45455 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'P4 (5)' at screen 0.40879,0.14918 center font ',7' tc rgb '#202020' noenhanced front
set label 'h3' at screen 0.45403,0.24825 center font ',7' tc rgb '#202020' noenhanced front
set label 'h9' at screen 0.37885,0.24825 center font ',7' tc rgb '#202020' noenhanced front
set label 'h8' at screen 0.30367,0.24825 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5 (6)' at screen 0.58842,0.14918 center font ',7' tc rgb '#202020' noenhanced front
set label 'h4' at screen 0.69633,0.24825 center font ',7' tc rgb '#202020' noenhanced front
set label 'h6' at screen 0.62115,0.24825 center font ',7' tc rgb '#202020' noenhanced front
set label 'h11' at screen 0.53759,0.24825 center font ',7' tc rgb '#202020' noenhanced front
set label 'distance P4 P5 = h10' at screen 0.49860,0.04196 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00000; set rmargin at screen 1.00000
set bmargin at screen 0.00000; set tmargin at screen 1.00000
set xrange [0:84]; set yrange [0:85.8]
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
