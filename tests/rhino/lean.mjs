// Writes a Rhino file without the tables and settings that geometry does not need: a few kB instead of some tens.
const tables = new Set([0x10000013, 0x10000011, 0x10000018, 0x10000021]);  // objects, layers, groups, block definitions
const kept = new Map([[0x10000015, new Set([0x20008031])],                 // settings: units
                      [0x10000014, new Set([0xa0000026])]]);               // properties: the version of openNURBS
const endOfTable = 0xffffffff, endOfFile = 0x7fff, comment = 1, userTable = 0x10000017, header = 32;

export function lean(bytes) {
    const big = Number(bytes.subarray(24, 32).toString().trim()) >= 50;
    const size = big ? 12 : 8;
    const chunks = function* (from, to) {
        while (from + size <= to) {
            const code = bytes.readUInt32LE(from);
            const value = big ? Number(bytes.readBigInt64LE(from + 4)) : bytes.readInt32LE(from + 4);
            const end = from + size + (code >= 0x80000000 ? 0 : value);
            yield { code, from, end };
            from = end;
        }
    };
    const chunk = (code, body) => {
        const head = Buffer.alloc(size);
        head.writeUInt32LE(code);
        if (big) head.writeBigInt64LE(BigInt(body.length), 4); else head.writeInt32LE(body.length, 4);
        return Buffer.concat([head, body]);
    };
    const parts = [bytes.subarray(0, header)];
    for (const { code, from, end } of chunks(header, bytes.length)) {
        if (code === comment) parts.push(chunk(code, Buffer.from('lean\0')));
        else if (tables.has(code)) parts.push(bytes.subarray(from, end));
        else if (code > 0x10000000 && code !== userTable) {  // openNURBS expects every table, even if it is empty
            const inner = [...chunks(from + size, end)].filter((c) => c.code === endOfTable || kept.get(code)?.has(c.code));
            parts.push(chunk(code, Buffer.concat(inner.map((c) => bytes.subarray(c.from, c.end)))));
        }
    }
    const total = parts.reduce((sum, part) => sum + part.length, 0) + 2 * size - (big ? 4 : 0);
    const tail = Buffer.alloc(big ? 8 : 4);
    if (big) tail.writeBigInt64LE(BigInt(total)); else tail.writeInt32LE(total);
    parts.push(chunk(endOfFile, tail));
    return Buffer.concat(parts);
}
