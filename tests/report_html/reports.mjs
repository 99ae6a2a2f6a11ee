// The reports under test, which the program writes once per run.
import { spawnSync } from 'node:child_process';
import { existsSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

const { RIPSTOP_PROGRAM: program, RIPSTOP_SHARED: shared, RIPSTOP_WORK: work } = process.env;

function ripstop(...args) {
    const run = spawnSync(program, args, { cwd: work, encoding: 'utf8' });
    if (![0, 1].includes(run.status)) throw new Error(`ripstop ${args.join(' ')}: ${run.stderr}`);
}

// The same with its pieces laid on the roll.
export function nested(page) {
    ripstop('nest', dirname(page), '--effort', '2', '--force', '--quiet');
    return page;
}

function flattened(name, input, ...options) {
    const page = join(work, name, 'report.html');
    if (!existsSync(join(work, name))) ripstop('flatten', input, '-o', name, '--quiet', ...options);
    return existsSync(page) ? page : null;
}

const dress = join(shared, 'dress', 'dress_knife_drape_3d.obj');

export const reports = {
    // The designed balloon: 24 gores of 15 panels, all manufacturable.
    designed() {
        if (!existsSync(join(work, 'balloon.obj')))
            ripstop('design', 'natural', '-o', 'balloon.obj', '--gores', '24', '--panels', '15');
        return flattened('designed', 'balloon.obj', '--fabric', 'nylon');
    },
    // A small balloon of few triangles, sewn and inflated with tapes up every gore.
    inflated() {
        const page = join(work, 'inflated', 'report.html');
        if (!existsSync(dirname(page))) {
            const size = ['--gores', '12', '--panels', '3', '--volume', '600', '--edge', '500mm'];
            ripstop('design', 'natural', '-o', 'small.obj', ...size);
            flattened('inflated', 'small.obj', '--fabric', 'nylon');
            ripstop('inflate', 'inflated', '--tapes', 'meridians', '--quiet');
        }
        return existsSync(page) ? page : null;
    },
    // A draped dress: panels that cannot be made, with proposed seams.
    dress: () => (existsSync(dress) ? flattened('dress', dress, '--unit', 'm') : null),
    // The same by a method that does not make the sides of seams equal.
    unequal: () => (existsSync(dress) ? flattened('unequal', dress, '--unit', 'm', '--method', 'lscm') : null),
    // Two tiles of five triangles, one of which is a disk that is not flat. Their seam has edges of 100 and 900
    // mm.
    uneven() {
        const corners = ['0 0 0', '1 0 0', '1 0.1 0', '1 1 0', '0 1 0', '0.5 0.5 0.3'];
        const others = ['1 0 0', '2 0 0', '2 1 0', '1 1 0', '1 0.1 0', '1.5 0.5 0'];
        const fan = (first) => [0, 1, 2, 3, 4].map((i) => `f ${first + i} ${first + ((i + 1) % 5)} ${first + 5}`);
        const vertices = (points) => points.map((point) => `v ${point}`);
        const lines = ['o left', ...vertices(corners), ...fan(1), 'o right', ...vertices(others), ...fan(7), ''];
        writeFileSync(join(work, 'uneven.obj'), lines.join('\n'));
        return flattened('uneven', 'uneven.obj', '--unit', 'm', '--method', 'lscm', '--remesh', 'never');
    },
    // Two squares sewn together, whose names are markup.
    hostile(names) {
        const text = `o ${names[0]}\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\no ${names[1]}\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 5 6 7 8\n`;
        writeFileSync(join(work, 'hostile.obj'), text);
        return flattened('hostile', 'hostile.obj', '--unit', 'm');
    },
};
