#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ripstop {

/// Integer arrays as bytes for the page: little-endian. Equal arrays are stored once, so equal tiles share theirs.
/// Every array starts at a multiple of 4 bytes.
class PackedArrays {
  public:
    /// The position of an array in `bytes`.
    struct Section {
        std::size_t start = 0, length = 0;  ///< [bytes]
    };

    /// Adds the numbers unchanged, 2 bytes each, in two's complement.
    int add(const std::vector<std::int16_t>& values);
    /// Adds the differences between consecutive rows (the first row's from 0), modulo 2^16 or 2^32. Consecutive rows
    /// are close, so the differences compress well. `columns`: numbers per row.
    int add_steps(const std::vector<std::uint16_t>& values, std::size_t columns);
    int add_steps(const std::vector<std::uint32_t>& values, std::size_t columns);

    const std::vector<Section>& places() const { return places_; }
    const std::string& bytes() const { return bytes_; }

  private:
    int add_bytes(std::string bytes);

    std::map<std::string, int> known_;
    std::vector<Section> places_;
    std::string bytes_;
};

/// Numbers as multiples of a step. The step is a power of two times `finest`, the smallest with which all numbers fit
/// into 16 bits, so equal maps get equal steps. A number that is not finite becomes the smallest 16-bit number.
struct SteppedValues {
    double step = 0;
    std::vector<std::int16_t> values;
};
SteppedValues stepped(const Eigen::VectorXd& values, double finest);

/// Points (#P x 2 or 3) on a grid with 2^16 places along the longest side of their bounding box.
struct GridPoints {
    Eigen::VectorXd lower;  ///< lower corner of the box
    double step = 0;
    std::vector<std::uint16_t> values;  ///< row by row
};
GridPoints on_grid(const Eigen::MatrixXd& points);

}  // namespace ripstop
