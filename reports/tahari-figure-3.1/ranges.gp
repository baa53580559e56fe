# x(1 - x) on [0, 1] and on [0, 2] by every bound
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' ranges.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,544 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,14.40cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'ranges.'.format
data = 'ranges.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 144 mm

# x-one-minus-x
set label 'x-one-minus-x' at screen 0.01149,0.98264 left font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.19540,0.51528 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.05747; set rmargin at screen 0.33333
set bmargin at screen 0.55903; set tmargin at screen 0.95486
unset logscale x
set xrange [0:1]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [0:0.30000000000000004]
set ytics ('0.0' 0, '0.1' 0.1, '0.2' 0.2, '0.3' 0.3)
set object 1 rectangle from graph 0,first 0 to graph 1,first 0.25 behind fs solid 1 noborder fc rgb '#E4E4E4'
set border 3
plot data index 0 using 1:2 with lines lw 1.2 lc rgb '#000000'
unset object
unset label; unset arrow
set label 'natural, x(1 − x)' at screen 0.52333,0.93687 right font ',7' tc rgb '#202020' noenhanced front
set label '[0, 1]' at screen 0.89196,0.93687 left font ',7' tc rgb '#202020' noenhanced front
set label 'natural, x − x²' at screen 0.52333,0.90088 right font ',7' tc rgb '#202020' noenhanced front
set label '[−1, 1]' at screen 0.89196,0.90088 left font ',7' tc rgb '#202020' noenhanced front
set label 'centred' at screen 0.52333,0.86490 right font ',7' tc rgb '#202020' noenhanced front
set label '[−0.25, 0.75]' at screen 0.89196,0.86490 left font ',7' tc rgb '#202020' noenhanced front
set label 'bicentred' at screen 0.52333,0.82891 right font ',7' tc rgb '#202020' noenhanced front
set label '[−0.25, 0.75]' at screen 0.89196,0.82891 left font ',7' tc rgb '#202020' noenhanced front
set label 'centred, second order' at screen 0.52333,0.79293 right font ',7' tc rgb '#202020' noenhanced front
set label '[0, 0.25]' at screen 0.89196,0.79293 left font ',7' tc rgb '#202020' noenhanced front
set label 'taubin' at screen 0.52333,0.75694 right font ',7' tc rgb '#202020' noenhanced front
set label '[0, 0.5]' at screen 0.89196,0.75694 left font ',7' tc rgb '#202020' noenhanced front
set label 'taubin_even' at screen 0.52333,0.72096 right font ',7' tc rgb '#202020' noenhanced front
set label '[0, 0.25]' at screen 0.89196,0.72096 left font ',7' tc rgb '#202020' noenhanced front
set label 'affine_chebyshev' at screen 0.52333,0.68497 right font ',7' tc rgb '#202020' noenhanced front
set label '[0, 0.25]' at screen 0.89196,0.68497 left font ',7' tc rgb '#202020' noenhanced front
set label 'affine_min_range' at screen 0.52333,0.64899 right font ',7' tc rgb '#202020' noenhanced front
set label '[0, 0.25]' at screen 0.89196,0.64899 left font ',7' tc rgb '#202020' noenhanced front
set label 'bernstein' at screen 0.52333,0.61301 right font ',7' tc rgb '#202020' noenhanced front
set label '[0, 0.5]' at screen 0.89196,0.61301 left font ',7' tc rgb '#202020' noenhanced front
set label 'exact' at screen 0.52333,0.57702 right font ',7' tc rgb '#202020' noenhanced front
set label '[0, 0.25]' at screen 0.89196,0.57702 left font ',7' tc rgb '#202020' noenhanced front
set label 'range of f' at screen 0.70765,0.51528 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.53195; set rmargin at screen 0.88334
set bmargin at screen 0.55903; set tmargin at screen 0.95486
unset logscale x
set xrange [-1:1]
set xtics ('−1.0' -1, '−0.5' -0.5, '0.0' 0, '0.5' 0.5, '1.0' 1)
set yrange [0.5:11.5]; set ytics ('' -1); unset logscale y
set object 1 rectangle from 0,graph 0 to 0.25,graph 1 behind fs solid 1 noborder fc rgb '#E4E4E4'
set border 1
plot data index 1 using 1:3:1:2:($3-0.22):($3+0.22) with boxxyerror fc rgb '#56B4E9' fs solid 1 border lc rgb '#0072B2' lw 0.6
unset object
unset label; unset arrow

# x-one-minus-x-wide
set label 'x-one-minus-x-wide' at screen 0.01149,0.48264 left font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.19540,0.01528 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.05747; set rmargin at screen 0.33333
set bmargin at screen 0.05903; set tmargin at screen 0.45486
unset logscale x
set xrange [0:2]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1, '1.5' 1.5, '2.0' 2)
unset logscale y
set yrange [-2:1]
set ytics ('−2' -2, '−1' -1, '0' 0, '1' 1)
set object 1 rectangle from graph 0,first -2 to graph 1,first 0.25 behind fs solid 1 noborder fc rgb '#E4E4E4'
set border 3
plot data index 2 using 1:2 with lines lw 1.2 lc rgb '#000000'
unset object
unset label; unset arrow
set label 'natural, x(1 − x)' at screen 0.52333,0.43687 right font ',7' tc rgb '#202020' noenhanced front
set label '[−2, 2]' at screen 0.89196,0.43687 left font ',7' tc rgb '#202020' noenhanced front
set label 'natural, x − x²' at screen 0.52333,0.40088 right font ',7' tc rgb '#202020' noenhanced front
set label '[−4, 2]' at screen 0.89196,0.40088 left font ',7' tc rgb '#202020' noenhanced front
set label 'centred' at screen 0.52333,0.36490 right font ',7' tc rgb '#202020' noenhanced front
set label '[−3, 3]' at screen 0.89196,0.36490 left font ',7' tc rgb '#202020' noenhanced front
set label 'bicentred' at screen 0.52333,0.32891 right font ',7' tc rgb '#202020' noenhanced front
set label '[−2.25, 1.75]' at screen 0.89196,0.32891 left font ',7' tc rgb '#202020' noenhanced front
set label 'centred, second order' at screen 0.52333,0.29293 right font ',7' tc rgb '#202020' noenhanced front
set label '[−2, 1]' at screen 0.89196,0.29293 left font ',7' tc rgb '#202020' noenhanced front
set label 'taubin' at screen 0.52333,0.25694 right font ',7' tc rgb '#202020' noenhanced front
set label '[−2, 2]' at screen 0.89196,0.25694 left font ',7' tc rgb '#202020' noenhanced front
set label 'taubin_even' at screen 0.52333,0.22096 right font ',7' tc rgb '#202020' noenhanced front
set label '[−2, 1]' at screen 0.89196,0.22096 left font ',7' tc rgb '#202020' noenhanced front
set label 'affine_chebyshev' at screen 0.52333,0.18497 right font ',7' tc rgb '#202020' noenhanced front
set label '[−2, 1]' at screen 0.89196,0.18497 left font ',7' tc rgb '#202020' noenhanced front
set label 'affine_min_range' at screen 0.52333,0.14899 right font ',7' tc rgb '#202020' noenhanced front
set label '[−2, 1]' at screen 0.89196,0.14899 left font ',7' tc rgb '#202020' noenhanced front
set label 'bernstein' at screen 0.52333,0.11301 right font ',7' tc rgb '#202020' noenhanced front
set label '[−2, 1]' at screen 0.89196,0.11301 left font ',7' tc rgb '#202020' noenhanced front
set label 'exact' at screen 0.52333,0.07702 right font ',7' tc rgb '#202020' noenhanced front
set label '[−2, 0.25]' at screen 0.89196,0.07702 left font ',7' tc rgb '#202020' noenhanced front
set label 'range of f' at screen 0.70765,0.01528 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.53195; set rmargin at screen 0.88334
set bmargin at screen 0.05903; set tmargin at screen 0.45486
unset logscale x
set xrange [-4:4]
set xtics ('−4' -4, '−2' -2, '0' 0, '2' 2, '4' 4)
set yrange [0.5:11.5]; set ytics ('' -1); unset logscale y
set object 1 rectangle from -2,graph 0 to 0.25,graph 1 behind fs solid 1 noborder fc rgb '#E4E4E4'
set border 1
plot data index 3 using 1:3:1:2:($3-0.22):($3+0.22) with boxxyerror fc rgb '#56B4E9' fs solid 1 border lc rgb '#0072B2' lw 0.6
unset object
unset label; unset arrow
unset multiplot
unset output
