# Covers of five curves: natural intervals above, Bernstein bases below
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' covers.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,276 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,7.29cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'covers.'.format
data = 'covers.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 73 mm

# natural / cassini-2-2
set label 'natural' at screen 0.01149,0.76543 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front
set label 'cassini-2-2' at screen 0.14138,0.96845 center font ',8' tc rgb '#202020' noenhanced front
set label '984 of 3,205' at screen 0.14138,0.51372 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.21379
set bmargin at screen 0.59259; set tmargin at screen 0.93827
set xrange [-2:2]
set format x '%.3g'
set xtics (-2, 0, 2)
set yrange [-2:2]
set format y '%.3g'
set ytics (-2, 0, 2)
plot data index 0 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 1 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 2 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# natural / martin-1
set label 'martin-1' at screen 0.33506,0.96845 center font ',8' tc rgb '#202020' noenhanced front
set label '10,982 of 17,401' at screen 0.33506,0.51372 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.26264; set rmargin at screen 0.40747
set bmargin at screen 0.59259; set tmargin at screen 0.93827
set xrange [0:1]
set format x '%.3g'
set xtics (0, 0.5, 1)
set yrange [0:1]
set format y '%.3g'
set ytics (0, 0.5, 1)
plot data index 3 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 4 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 5 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# natural / random-10
set label 'random-10' at screen 0.52874,0.96845 center font ',8' tc rgb '#202020' noenhanced front
set label '2,560 of 8,105' at screen 0.52874,0.51372 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.45632; set rmargin at screen 0.60115
set bmargin at screen 0.59259; set tmargin at screen 0.93827
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y '%.3g'
set ytics (-1, 0, 1)
plot data index 6 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 7 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 8 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# natural / random-14
set label 'random-14' at screen 0.72241,0.96845 center font ',8' tc rgb '#202020' noenhanced front
set label '3,162 of 11,665' at screen 0.72241,0.51372 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.65000; set rmargin at screen 0.79483
set bmargin at screen 0.59259; set tmargin at screen 0.93827
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y ''
set ytics (-1, 0, 1)
plot data index 9 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 10 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 11 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# natural / random-18
set label 'random-18' at screen 0.91609,0.96845 center font ',8' tc rgb '#202020' noenhanced front
set label '5,519 of 16,489' at screen 0.91609,0.51372 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.84368; set rmargin at screen 0.98851
set bmargin at screen 0.59259; set tmargin at screen 0.93827
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y ''
set ytics (-1, 0, 1)
plot data index 12 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 13 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 14 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# bernstein / cassini-2-2
set label 'bernstein' at screen 0.01149,0.28258 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front
set label '384 of 1,509' at screen 0.14138,0.03086 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.21379
set bmargin at screen 0.10974; set tmargin at screen 0.45542
set xrange [-2:2]
set format x '%.3g'
set xtics (-2, 0, 2)
set yrange [-2:2]
set format y '%.3g'
set ytics (-2, 0, 2)
plot data index 15 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 16 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 17 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# bernstein / martin-1
set label '266 of 1,077' at screen 0.33506,0.03086 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.26264; set rmargin at screen 0.40747
set bmargin at screen 0.10974; set tmargin at screen 0.45542
set xrange [0:1]
set format x '%.3g'
set xtics (0, 0.5, 1)
set yrange [0:1]
set format y '%.3g'
set ytics (0, 0.5, 1)
plot data index 18 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 19 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 20 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# bernstein / random-10
set label '260 of 1,053' at screen 0.52874,0.03086 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.45632; set rmargin at screen 0.60115
set bmargin at screen 0.10974; set tmargin at screen 0.45542
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y '%.3g'
set ytics (-1, 0, 1)
plot data index 21 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 22 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 23 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# bernstein / random-14
set label '368 of 1,429' at screen 0.72241,0.03086 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.65000; set rmargin at screen 0.79483
set bmargin at screen 0.10974; set tmargin at screen 0.45542
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y ''
set ytics (-1, 0, 1)
plot data index 24 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 25 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 26 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# bernstein / random-18
set label '432 of 1,721' at screen 0.91609,0.03086 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.84368; set rmargin at screen 0.98851
set bmargin at screen 0.10974; set tmargin at screen 0.45542
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y ''
set ytics (-1, 0, 1)
plot data index 27 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 28 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 29 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow
unset multiplot
unset output
