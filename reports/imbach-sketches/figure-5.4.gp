# Sketches of the hexahedron, problem 3, and of the flat problem 4, with the parameters of their lengths
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-5.4.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,467 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,12.35cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-5.4.'.format
data = 'figure-5.4.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 124 mm
set label '' at screen 0.52976,0.97571 center font ',8' tc rgb '#202020' noenhanced front
set label 'hexahedron' at screen 0.02619,0.73930 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.52976,0.50857 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.09330,0.89627 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.28200,0.53694 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.49268,0.94165 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.27306,0.83741 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.97340,0.82894 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.62338,0.84068 center font ',7' tc rgb '#202020' noenhanced front
set label 'P6' at screen 0.24098,0.76864 center font ',7' tc rgb '#202020' noenhanced front
set label 'P7' at screen 0.85745,0.66691 center font ',7' tc rgb '#202020' noenhanced front
set label 'h1' at screen 0.21548,0.88103 center font ',7' tc rgb '#606060' noenhanced front
set label 'h6' at screen 0.21436,0.84494 center font ',7' tc rgb '#606060' noenhanced front
set label 'h3' at screen 0.37897,0.90270 center font ',7' tc rgb '#606060' noenhanced front
set label 'h9' at screen 0.85889,0.76052 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5' at screen 0.41970,0.85634 center font ',7' tc rgb '#606060' noenhanced front
set label 'h10' at screen 0.39233,0.81704 center font ',7' tc rgb '#606060' noenhanced front
set label 'h8' at screen 0.76911,0.84073 center font ',7' tc rgb '#606060' noenhanced front
set label 'h4' at screen 0.72196,0.89006 center font ',7' tc rgb '#606060' noenhanced front
set label 'h0' at screen 0.23502,0.72503 center font ',7' tc rgb '#606060' noenhanced front
set label 'h7' at screen 0.55470,0.63380 center font ',7' tc rgb '#606060' noenhanced front
set label 'h2' at screen 0.36377,0.74587 center font ',7' tc rgb '#606060' noenhanced front
set label 'h11' at screen 0.55632,0.74716 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.06548; set rmargin at screen 0.99405
set bmargin at screen 0.52314; set tmargin at screen 0.95547
set xrange [-0.10458595:1.7858866]; set yrange [-1.06902593:0.225167768]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 2 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 3 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 4 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 5 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 6 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
set label 'hexahedron-flat' at screen 0.02619,0.26359 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front

# line 2, column 1
set label '' at screen 0.52976,0.00567 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.57897,0.03406 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.97340,0.35342 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.46949,0.49313 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.08819,0.26670 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.46373,0.36330 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.31978,0.25656 center font ',7' tc rgb '#202020' noenhanced front
set label 'P6' at screen 0.48631,0.17070 center font ',7' tc rgb '#202020' noenhanced front
set label 'P7' at screen 0.75298,0.29343 center font ',7' tc rgb '#202020' noenhanced front
set label 'h4' at screen 0.51257,0.41801 center font ',7' tc rgb '#606060' noenhanced front
set label 'h8' at screen 0.40135,0.32799 center font ',7' tc rgb '#606060' noenhanced front
set label 'h10' at screen 0.44983,0.24618 center font ',7' tc rgb '#606060' noenhanced front
set label 'h6' at screen 0.56861,0.12561 center font ',7' tc rgb '#606060' noenhanced front
set label 'h7' at screen 0.82626,0.34303 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5' at screen 0.23261,0.28148 center font ',7' tc rgb '#606060' noenhanced front
set label 'h9' at screen 0.61768,0.34815 center font ',7' tc rgb '#606060' noenhanced front
set label 'h11' at screen 0.59486,0.26430 center font ',7' tc rgb '#606060' noenhanced front
set label 'h3' at screen 0.27744,0.38616 center font ',7' tc rgb '#606060' noenhanced front
set label 'h2' at screen 0.71976,0.42822 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1' at screen 0.36092,0.17605 center font ',7' tc rgb '#606060' noenhanced front
set label 'h0' at screen 0.73396,0.21372 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.06548; set rmargin at screen 0.99405
set bmargin at screen 0.02024; set tmargin at screen 0.50695
set xrange [-1.87801667:1.56718091]; set yrange [-0.176676799:2.47850594]
set border 0; unset xtics; unset ytics
plot data index 10 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 11 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 12 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 13 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 14 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 15 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 16 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 17 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 18 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 19 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 20 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
