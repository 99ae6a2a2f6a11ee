#!/bin/sh
# Shows the main use on a hot-air balloon: designs an envelope, flattens it, and names the files to open.
set -eu
cd "$(dirname "$0")/.."
ripstop=build/release/ripstop
mkdir -p demo
$ripstop design natural -o demo/envelope.obj --gores 24 --panels 15 --volume 3000 --force
code=0
$ripstop flatten demo/envelope.obj --fabric nylon -o demo/cut-plan --force || code=$?
[ "$code" -le 1 ] || exit "$code"
cat <<END

Open these:
  demo/cut-plan/report.html                 the verdict, the envelope and its pieces (any browser, by double click)
  demo/envelope.obj                         the envelope in space (any 3D viewer, Rhino, Blender)
  demo/cut-plan/cut/envelope.svg            every piece, true size
  demo/cut-plan/cut/envelope.dxf            the same for the cutter (R12, millimetres)
  demo/cut-plan/cut/envelope.pdf            paper templates, a page each
  demo/cut-plan/pictures/G01P08.svg         one piece in the colours of its error
  demo/cut-plan/report.json, tiles.csv      every figure; seams.csv, pictures/seams.svg: how the edges fit
END
