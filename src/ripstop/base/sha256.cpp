#include "ripstop/base/sha256.h"

#include <array>
#include <bit>
#include <cstdint>
#include <istream>

namespace ripstop {
namespace {

// Letters as in FIPS 180-4: H is the state, K the round constants (section 4.2.2), W the message schedule (6.2.2).
constexpr std::array<std::uint32_t, 64> K = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

using State = std::array<std::uint32_t, 8>;
constexpr State initial = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                           0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
constexpr std::size_t block_size = 64;

void hash_block(State& H, const char* block) {
    std::array<std::uint32_t, 64> W;
    for (std::size_t t = 0; t < 16; ++t) {
        W[t] = 0;
        for (std::size_t k = 0; k < 4; ++k) W[t] = W[t] << 8 | static_cast<unsigned char>(block[4 * t + k]);
    }
    for (std::size_t t = 16; t < 64; ++t) {
        const std::uint32_t s0 = std::rotr(W[t - 15], 7) ^ std::rotr(W[t - 15], 18) ^ (W[t - 15] >> 3);
        const std::uint32_t s1 = std::rotr(W[t - 2], 17) ^ std::rotr(W[t - 2], 19) ^ (W[t - 2] >> 10);
        W[t] = s1 + W[t - 7] + s0 + W[t - 16];
    }
    auto [a, b, c, d, e, f, g, h] = H;
    for (std::size_t t = 0; t < 64; ++t) {
        const std::uint32_t S1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const std::uint32_t T1 = h + S1 + ((e & f) ^ (~e & g)) + K[t] + W[t];
        const std::uint32_t S0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const std::uint32_t T2 = S0 + ((a & b) ^ (a & c) ^ (b & c));
        h = g;
        g = f;
        f = e;
        e = d + T1;
        d = c;
        c = b;
        b = a;
        a = T1 + T2;
    }
    const State update = {a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < H.size(); ++i) H[i] += update[i];
}

/// Pads and hashes the bytes after the last whole block, and returns the digest in hexadecimal.
std::string finished(State H, std::string_view rest, std::uint64_t total_bytes) {
    std::string tail(rest);
    tail += '\x80';
    while (tail.size() % block_size != block_size - 8) tail += '\0';
    for (int shift = 56; shift >= 0; shift -= 8) tail += static_cast<char>(total_bytes * 8 >> shift & 0xff);
    for (std::size_t i = 0; i < tail.size(); i += block_size) hash_block(H, tail.data() + i);
    std::string digest;
    for (const std::uint32_t word : H)
        for (int shift = 28; shift >= 0; shift -= 4) digest += "0123456789abcdef"[word >> shift & 0xf];
    return digest;
}

}  // namespace

std::string sha256(std::string_view bytes) {
    State H = initial;
    std::size_t done = 0;
    for (; done + block_size <= bytes.size(); done += block_size) hash_block(H, bytes.data() + done);
    return finished(H, bytes.substr(done), bytes.size());
}

std::string sha256(std::istream& in) {
    State H = initial;
    std::uint64_t total = 0;
    std::string buffer(1024 * block_size, '\0');
    for (;;) {
        in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        const auto count = static_cast<std::size_t>(in.gcount());
        total += count;
        std::size_t done = 0;
        for (; done + block_size <= count; done += block_size) hash_block(H, buffer.data() + done);
        if (count < buffer.size()) return finished(H, std::string_view(buffer).substr(done, count - done), total);
    }
}

}  // namespace ripstop
