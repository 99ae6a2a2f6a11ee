#!/bin/sh
# The main job on a hot-air balloon that can be cut and flown: design an envelope, flatten it, inflate it, lay its
# pieces on the roll, and name the files to open.
set -eu
cd "$(dirname "$0")/.."
ripstop=build/release/ripstop
mkdir -p demo
$ripstop design natural -o demo/envelope.obj --gores 24 --panel-height 1350mm --lobes 12 --volume 2200 --force
$ripstop flatten demo/envelope.obj --unit m --fabric nylon -o demo/cut-plan --force
$ripstop inflate demo/cut-plan --tapes meridians
$ripstop nest demo/cut-plan --effort 4
cat <<END

Open these:
  demo/cut-plan/report.html                 the verdict, the envelope on the ground and in flight, its pieces, the roll
  demo/envelope.obj                         the envelope in space (any 3D viewer, Rhino, Blender)
  demo/cut-plan/cut/envelope.dxf            every piece for the cutter, true size (R12, millimetres); .svg beside it
  demo/cut-plan/cut/envelope.pdf            paper templates, a page each
  demo/cut-plan/marker/marker.pdf           the pieces on the roll; bom.csv beside it: what to order
  demo/cut-plan/report.json, tiles.csv      every figure; seams.csv: how the edges fit
END
