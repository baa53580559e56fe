# Circle packings of triangulated planar graphs: exactly one each
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' packings.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,396 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,10.47cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'packings.'.format
data = 'packings.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 105 mm
set style textbox opaque noborder margins 0.6,0.6

# octahedron-graph, 3 discs
set label 'octahedron-graph, 3 discs' at screen 0.16667,0.97326 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.16667,0.44938 center font ',7' tc rgb '#202020' noenhanced front
set label '' at screen 0.01149,0.73090 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.01724; set rmargin at screen 0.31609
set bmargin at screen 0.50955; set tmargin at screen 0.95224
unset logscale x
set xrange [-0.02:1.8199999999999998]
set xtics ('' 0, '' 0.5, '' 1, '' 1.5)
unset logscale y
set yrange [-0.02:1.62]
set ytics ('' 0, '' 0.5, '' 1, '' 1.5)
set border 0; set tics scale 0
plot \
  data index 0 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 0 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 1 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 1 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 2 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 2 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 3 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 3 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 4 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 4 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 5 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 5 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 6 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 7 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 8 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 9 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 10 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 11 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 12 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 13 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 14 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0'
unset label; unset arrow

# random-9, 3 discs
set label 'random-9, 3 discs' at screen 0.50000,0.97326 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.50000,0.44938 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.35057; set rmargin at screen 0.64943
set bmargin at screen 0.50955; set tmargin at screen 0.95224
unset logscale x
set xrange [-0.02:1.8199999999999998]
set xtics ('' 0, '' 0.5, '' 1, '' 1.5)
unset logscale y
set yrange [-0.02:1.62]
set ytics ('' 0, '' 0.5, '' 1, '' 1.5)
set border 0; set tics scale 0
plot \
  data index 15 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 15 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 16 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 16 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 17 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 17 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 18 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 18 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 19 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 19 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 20 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 20 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 21 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 22 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 23 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 24 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 25 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 26 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 27 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 28 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 29 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0'
unset label; unset arrow

# icosahedron-graph, 9 discs
set label 'icosahedron-graph, 9 discs' at screen 0.83333,0.97326 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.83333,0.44938 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.68391; set rmargin at screen 0.98276
set bmargin at screen 0.50955; set tmargin at screen 0.95224
unset logscale x
set xrange [-0.02:1.8199999999999998]
set xtics ('' 0, '' 0.5, '' 1, '' 1.5)
unset logscale y
set yrange [-0.02:1.62]
set ytics ('' 0, '' 0.5, '' 1, '' 1.5)
set border 0; set tics scale 0
plot \
  data index 30 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 30 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 31 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 31 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 32 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 32 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 33 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 33 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 34 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 34 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 35 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 35 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 36 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 36 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 37 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 37 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 38 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 38 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 39 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 39 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 40 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 40 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 41 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 41 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 42 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 43 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 44 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 45 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 46 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 47 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 48 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 49 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 50 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 51 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 52 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 53 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 54 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 55 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 56 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 57 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 58 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 59 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 60 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 61 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 62 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 63 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 64 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 65 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 66 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 67 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 68 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0'
unset label; unset arrow

# random-27, 9 discs
set label 'random-27, 9 discs' at screen 0.16667,0.47326 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.16667,-0.05062 center font ',7' tc rgb '#202020' noenhanced front
set label '' at screen 0.01149,0.23090 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.01724; set rmargin at screen 0.31609
set bmargin at screen 0.00955; set tmargin at screen 0.45224
unset logscale x
set xrange [-0.02:1.8199999999999998]
set xtics ('' 0, '' 0.5, '' 1, '' 1.5)
unset logscale y
set yrange [-0.02:1.62]
set ytics ('' 0, '' 0.5, '' 1, '' 1.5)
set border 0; set tics scale 0
plot \
  data index 69 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 69 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 70 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 70 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 71 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 71 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 72 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 72 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 73 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 73 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 74 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 74 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 75 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 75 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 76 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 76 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 77 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 77 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 78 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 78 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 79 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 79 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 80 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 80 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 81 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 82 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 83 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 84 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 85 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 86 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 87 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 88 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 89 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 90 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 91 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 92 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 93 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 94 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 95 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 96 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 97 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 98 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 99 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 100 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 101 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 102 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 103 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 104 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 105 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 106 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 107 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0'
unset label; unset arrow

# random-60, 20 discs
set label 'random-60, 20 discs' at screen 0.50000,0.47326 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.50000,-0.05062 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.35057; set rmargin at screen 0.64943
set bmargin at screen 0.00955; set tmargin at screen 0.45224
unset logscale x
set xrange [-0.02:1.8199999999999998]
set xtics ('' 0, '' 0.5, '' 1, '' 1.5)
unset logscale y
set yrange [-0.02:1.62]
set ytics ('' 0, '' 0.5, '' 1, '' 1.5)
set border 0; set tics scale 0
plot \
  data index 108 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 108 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 109 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 109 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 110 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 110 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 111 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 111 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 112 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 112 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 113 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 113 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 114 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 114 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 115 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 115 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 116 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 116 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 117 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 117 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 118 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 118 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 119 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 119 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 120 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 120 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 121 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 121 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 122 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 122 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 123 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 123 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 124 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 124 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 125 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 125 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 126 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 126 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 127 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 127 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 128 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 128 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 129 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 129 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 130 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 130 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 131 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 132 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 133 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 134 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 135 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 136 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 137 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 138 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 139 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 140 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 141 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 142 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 143 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 144 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 145 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 146 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 147 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 148 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 149 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 150 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 151 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 152 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 153 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 154 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 155 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 156 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 157 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 158 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 159 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 160 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 161 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 162 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 163 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 164 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 165 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 166 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 167 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 168 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 169 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 170 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 171 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 172 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 173 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 174 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 175 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 176 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 177 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 178 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 179 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 180 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 181 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 182 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 183 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 184 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 185 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 186 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 187 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 188 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 189 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 190 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0'
unset label; unset arrow

# random-180, 60 discs
set label 'random-180, 60 discs' at screen 0.83333,0.47326 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.83333,-0.05062 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.68391; set rmargin at screen 0.98276
set bmargin at screen 0.00955; set tmargin at screen 0.45224
unset logscale x
set xrange [-0.02:1.8199999999999998]
set xtics ('' 0, '' 0.5, '' 1, '' 1.5)
unset logscale y
set yrange [-0.02:1.62]
set ytics ('' 0, '' 0.5, '' 1, '' 1.5)
set border 0; set tics scale 0
plot \
  data index 191 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 191 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 192 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 192 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 193 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 193 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 194 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 194 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 195 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 195 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 196 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 196 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 197 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 197 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 198 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 198 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 199 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 199 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 200 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 200 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 201 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 201 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 202 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 202 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 203 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 203 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 204 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 204 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 205 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 205 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 206 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 206 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 207 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 207 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 208 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 208 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 209 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 209 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 210 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 210 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 211 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 211 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 212 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 212 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 213 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 213 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 214 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 214 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 215 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 215 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 216 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 216 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 217 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 217 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 218 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 218 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 219 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 219 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 220 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 220 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 221 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 221 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 222 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 222 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 223 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 223 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 224 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 224 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 225 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 225 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 226 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 226 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 227 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 227 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 228 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 228 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 229 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 229 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 230 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 230 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 231 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 231 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 232 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 232 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 233 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 233 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 234 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 234 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 235 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 235 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 236 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 236 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 237 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 237 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 238 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 238 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 239 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 239 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 240 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 240 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 241 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 241 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 242 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 242 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 243 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 243 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 244 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 244 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 245 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 245 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 246 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 246 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 247 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 247 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 248 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 248 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 249 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 249 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 250 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 250 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 251 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 251 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 252 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 252 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 253 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 253 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 254 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 255 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 256 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 257 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 258 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 259 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 260 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 261 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 262 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 263 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 264 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 265 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 266 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 267 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 268 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 269 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 270 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 271 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 272 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 273 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 274 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 275 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 276 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 277 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 278 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 279 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 280 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 281 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 282 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 283 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 284 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 285 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 286 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 287 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 288 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 289 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 290 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 291 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 292 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 293 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 294 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 295 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 296 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 297 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 298 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 299 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 300 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 301 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 302 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 303 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 304 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 305 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 306 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 307 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 308 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 309 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 310 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 311 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 312 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 313 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 314 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 315 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 316 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 317 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 318 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 319 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 320 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 321 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 322 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 323 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 324 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 325 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 326 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 327 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 328 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 329 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 330 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 331 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 332 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 333 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 334 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 335 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 336 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 337 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 338 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 339 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 340 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 341 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 342 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 343 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 344 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 345 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 346 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 347 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 348 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 349 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 350 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 351 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 352 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 353 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 354 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 355 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 356 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 357 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 358 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 359 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 360 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 361 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 362 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 363 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 364 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 365 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 366 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 367 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 368 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 369 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 370 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 371 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 372 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 373 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 374 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 375 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 376 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 377 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 378 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 379 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 380 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 381 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 382 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 383 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 384 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 385 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 386 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 387 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 388 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 389 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 390 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 391 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 392 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 393 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 394 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 395 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 396 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 397 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 398 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 399 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 400 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 401 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 402 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 403 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 404 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 405 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 406 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 407 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 408 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 409 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 410 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 411 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 412 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 413 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 414 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 415 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 416 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 417 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 418 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 419 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 420 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 421 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 422 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 423 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 424 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 425 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 426 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 427 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 428 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 429 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 430 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 431 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 432 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0', \
  data index 433 using 1:2 with lines lw 0.5 dt 1 lc rgb '#A0A0A0'
unset label; unset arrow
unset multiplot
unset output
