# Random sketches by the number of certified figures on their path, by what becomes of coplanarities; the number is the leading coefficient where the sketch was moved to satisfy them
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' classes.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,461 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,12.21cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'classes.'.format
data = 'classes.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 122 mm

# octahedron
set label 'octahedron' at screen 0.07471,0.97707 left font ',8' tc rgb '#202020' noenhanced front
set label 'k: regular classes' at screen 0.29454,0.53890 center font ',7' tc rgb '#202020' noenhanced front
set label 'jobs with k or more [%]' at screen 0.01149,0.77477 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.07144,0.01474 to screen 0.10880,0.01474 nohead lc rgb '#0072B2' dt 1 lw 1
set label '' at screen 0.09012,0.01474 point pt 7 ps 0.45 lc rgb '#0072B2'
set label 'perturbed' at screen 0.11742,0.01474 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.25888,0.01474 to screen 0.29624,0.01474 nohead lc rgb '#D55E00' dt 1 lw 1
set label '' at screen 0.27756,0.01474 point pt 5 ps 0.45 lc rgb '#D55E00'
set label 'projected, 0.1' at screen 0.30486,0.01474 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.44631,0.01474 to screen 0.48367,0.01474 nohead lc rgb '#009E73' dt 1 lw 1
set label '' at screen 0.46499,0.01474 point pt 9 ps 0.45 lc rgb '#009E73'
set label 'projected, 1' at screen 0.49229,0.01474 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.63375,0.01474 to screen 0.67111,0.01474 nohead lc rgb '#E69F00' dt 1 lw 1
set label '' at screen 0.65243,0.01474 point pt 13 ps 0.45 lc rgb '#E69F00'
set label 'projected, -0.1' at screen 0.67973,0.01474 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.82119,0.01474 to screen 0.85854,0.01474 nohead lc rgb '#CC79A7' dt 1 lw 1
set label '' at screen 0.83986,0.01474 point pt 11 ps 0.45 lc rgb '#CC79A7'
set label 'kept' at screen 0.86716,0.01474 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.07471; set rmargin at screen 0.51437
set bmargin at screen 0.59050; set tmargin at screen 0.95905
unset logscale x
set xrange [0:4.5]
set xtics ('0' 0, '2' 2, '4' 4)
unset logscale y
set yrange [0:103]
set ytics ('0' 0, '20' 20, '40' 40, '60' 60, '80' 80, '100' 100)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 0 using 1:2 with fsteps lc rgb '#0072B2' dt 1 lw 1.2, \
  data index 0 using 1:2 with points pt 7 ps 0.4 lc rgb '#0072B2', \
  data index 1 using 1:2 with fsteps lc rgb '#D55E00' dt 1 lw 1.2, \
  data index 1 using 1:2 with points pt 5 ps 0.4 lc rgb '#D55E00', \
  data index 2 using 1:2 with fsteps lc rgb '#009E73' dt 1 lw 1.2, \
  data index 2 using 1:2 with points pt 9 ps 0.4 lc rgb '#009E73', \
  data index 3 using 1:2 with fsteps lc rgb '#E69F00' dt 1 lw 1.2, \
  data index 3 using 1:2 with points pt 13 ps 0.4 lc rgb '#E69F00', \
  data index 4 using 1:2 with fsteps lc rgb '#CC79A7' dt 1 lw 1.2, \
  data index 4 using 1:2 with points pt 11 ps 0.4 lc rgb '#CC79A7'
unset label; unset arrow

# pentahedron
set label 'pentahedron' at screen 0.54310,0.97707 left font ',8' tc rgb '#202020' noenhanced front
set label 'k: regular classes' at screen 0.76293,0.53890 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.54310; set rmargin at screen 0.98276
set bmargin at screen 0.59050; set tmargin at screen 0.95905
unset logscale x
set xrange [0:9.5]
set xtics ('0' 0, '1' 1, '2' 2, '3' 3, '4' 4, '5' 5, '6' 6, '7' 7, '8' 8, '9' 9)
unset logscale y
set yrange [0:103]
set ytics ('' 0, '' 20, '' 40, '' 60, '' 80, '' 100)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 5 using 1:2 with fsteps lc rgb '#0072B2' dt 1 lw 1.2, \
  data index 5 using 1:2 with points pt 7 ps 0.4 lc rgb '#0072B2', \
  data index 6 using 1:2 with fsteps lc rgb '#D55E00' dt 1 lw 1.2, \
  data index 6 using 1:2 with points pt 5 ps 0.4 lc rgb '#D55E00', \
  data index 7 using 1:2 with fsteps lc rgb '#009E73' dt 1 lw 1.2, \
  data index 7 using 1:2 with points pt 9 ps 0.4 lc rgb '#009E73', \
  data index 8 using 1:2 with fsteps lc rgb '#E69F00' dt 1 lw 1.2, \
  data index 8 using 1:2 with points pt 13 ps 0.4 lc rgb '#E69F00', \
  data index 9 using 1:2 with fsteps lc rgb '#CC79A7' dt 1 lw 1.2, \
  data index 9 using 1:2 with points pt 11 ps 0.4 lc rgb '#CC79A7'
unset label; unset arrow

# hexahedron
set label 'hexahedron' at screen 0.07471,0.49386 left font ',8' tc rgb '#202020' noenhanced front
set label 'k: regular classes' at screen 0.29454,0.05569 center font ',7' tc rgb '#202020' noenhanced front
set label 'jobs with k or more [%]' at screen 0.01149,0.29156 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.07471; set rmargin at screen 0.51437
set bmargin at screen 0.10729; set tmargin at screen 0.47584
unset logscale x
set xrange [0:16.5]
set xtics ('0' 0, '5' 5, '10' 10, '15' 15)
unset logscale y
set yrange [0:103]
set ytics ('0' 0, '20' 20, '40' 40, '60' 60, '80' 80, '100' 100)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 10 using 1:2 with fsteps lc rgb '#0072B2' dt 1 lw 1.2, \
  data index 10 using 1:2 with points pt 7 ps 0.4 lc rgb '#0072B2', \
  data index 11 using 1:2 with fsteps lc rgb '#D55E00' dt 1 lw 1.2, \
  data index 11 using 1:2 with points pt 5 ps 0.4 lc rgb '#D55E00', \
  data index 12 using 1:2 with fsteps lc rgb '#009E73' dt 1 lw 1.2, \
  data index 12 using 1:2 with points pt 9 ps 0.4 lc rgb '#009E73', \
  data index 13 using 1:2 with fsteps lc rgb '#E69F00' dt 1 lw 1.2, \
  data index 13 using 1:2 with points pt 13 ps 0.4 lc rgb '#E69F00', \
  data index 14 using 1:2 with fsteps lc rgb '#CC79A7' dt 1 lw 1.2, \
  data index 14 using 1:2 with points pt 11 ps 0.4 lc rgb '#CC79A7'
unset label; unset arrow

# disulfide-distances
set label 'disulfide-distances' at screen 0.54310,0.49386 left font ',8' tc rgb '#202020' noenhanced front
set label 'k: regular classes' at screen 0.76293,0.05569 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.54310; set rmargin at screen 0.98276
set bmargin at screen 0.10729; set tmargin at screen 0.47584
unset logscale x
set xrange [0:18.54]
set xtics ('0' 0, '2' 2, '4' 4, '6' 6, '8' 8, '10' 10, '12' 12, '14' 14, '16' 16, '18' 18)
unset logscale y
set yrange [0:103]
set ytics ('' 0, '' 20, '' 40, '' 60, '' 80, '' 100)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 15 using 1:2 with fsteps lc rgb '#0072B2' dt 1 lw 1.2, \
  data index 15 using 1:2 with points pt 7 ps 0.4 lc rgb '#0072B2', \
  data index 16 using 1:2 with fsteps lc rgb '#D55E00' dt 1 lw 1.2, \
  data index 16 using 1:2 with points pt 5 ps 0.4 lc rgb '#D55E00', \
  data index 17 using 1:2 with fsteps lc rgb '#009E73' dt 1 lw 1.2, \
  data index 17 using 1:2 with points pt 9 ps 0.4 lc rgb '#009E73', \
  data index 18 using 1:2 with fsteps lc rgb '#E69F00' dt 1 lw 1.2, \
  data index 18 using 1:2 with points pt 13 ps 0.4 lc rgb '#E69F00', \
  data index 19 using 1:2 with fsteps lc rgb '#CC79A7' dt 1 lw 1.2, \
  data index 19 using 1:2 with points pt 11 ps 0.4 lc rgb '#CC79A7'
unset label; unset arrow
unset multiplot
unset output
