# A constraint system in the plane: the lines carry the constraints of angles; P2 and P5 are an articulation pair
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-2.2.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 306,314 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.10cm,8.31cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-2.2.'.format
data = 'figure-2.2.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 81 mm x 83 mm
set label 'articulation-pair' at screen 0.50000,0.96391 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.50000,0.00842 center font ',7' tc rgb '#606060' noenhanced front
set label 'P1' at screen 0.23045,0.14590 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.76955,0.14590 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.91164,0.55196 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.50759,0.81798 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.08836,0.55196 center font ',7' tc rgb '#202020' noenhanced front
set label 'l1' at screen 0.09661,0.70639 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'l2' at screen 0.90531,0.15261 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'l3' at screen 0.71238,0.14795 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'l4' at screen 0.44689,0.86031 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'a1' at screen 0.17602,0.22324 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'a2' at screen 0.90667,0.46729 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'h2' at screen 0.78763,0.36795 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5' at screen 0.21237,0.36795 center font ',7' tc rgb '#606060' noenhanced front
set label 'h3' at screen 0.70667,0.69153 center font ',7' tc rgb '#606060' noenhanced front
set label 'h4' at screen 0.29333,0.69153 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1' at screen 0.50000,0.19443 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.03008; set tmargin at screen 0.93383
set xrange [-1.90081687:5.90081687]; set yrange [-1.16264295:6.16264295]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 1 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 2 using 1:2 with lines lw 0.6 lc rgb '#D55E00', \
  data index 3 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
