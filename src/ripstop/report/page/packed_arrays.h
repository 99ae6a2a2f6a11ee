#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ripstop {

/// Arrays of whole numbers as bytes, for a page to read: little-endian, each array once however often it is asked for,
/// so equal tiles share theirs. Every array starts at a multiple of 4 bytes.
class PackedArrays {
  public:
    /// Where an array stands in `bytes`.
    struct Place {
        std::size_t start = 0, length = 0;  ///< [bytes]
    };

    /// Numbers as they are, 2 bytes each, in two's complement.
    int add(const std::vector<std::int16_t>& values);
    /// Differences between one row and the next (the first row's from 0), modulo 2^16 or 2^32: neighbours are near one
    /// another, so that packing finds little to say. `columns` numbers a row.
    int add_steps(const std::vector<std::uint16_t>& values, std::size_t columns);
    int add_steps(const std::vector<std::uint32_t>& values, std::size_t columns);

    const std::vector<Place>& places() const { return places_; }
    const std::string& bytes() const { return bytes_; }

  private:
    int add_bytes(std::string bytes);

    std::map<std::string, int> known_;
    std::vector<Place> places_;
    std::string bytes_;
};

/// Numbers as multiples of a step, which is a power of two times `finest` and the smallest that lets all of them fit
/// into 16 bits: equal maps get equal steps. What is not finite becomes the smallest number there is.
struct SteppedValues {
    double step = 0;
    std::vector<std::int16_t> values;
};
SteppedValues stepped(const Eigen::VectorXd& values, double finest);

/// Points (#P x 2 or 3) on a grid of 2^16 places along the longest side of their box.
struct GridPoints {
    Eigen::VectorXd lower;  ///< of the box
    double step = 0;
    std::vector<std::uint16_t> values;  ///< row by row
};
GridPoints on_grid(const Eigen::MatrixXd& points);

}  // namespace ripstop
