// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/GaussianFilter.h"

#include "core/base/ParallelFor.h"
#include "core/morphology/GridGaussian.h"
#include "core/morphology/StageCounter.h"

#include <algorithm>
#include <span>

namespace core {

namespace {

/// The weights of an axis, with what they add up to.
class AxisWeights {
public:
    /// @param length of the box along the axis
    AxisWeights(
        const std::vector<std::uint32_t>& weights, int length, bool goesOnBefore, bool goesOnBehind)
        : m_weights(weights)
        , m_length(length)
        , m_goesOnBefore(goesOnBefore)
        , m_goesOnBehind(goesOnBehind)
        , m_from(weights.size() + 1, 0)
    {
        for (std::size_t step = weights.size(); step > 0; --step)
            m_from[step - 1] = m_from[step] + weights[step - 1];
    }

    [[nodiscard]] int first(int at) const { return std::max(0, at - reach()); }
    [[nodiscard]] int last(int at) const { return std::min(m_length - 1, at + reach()); }
    /// The weight with which the voxel at @p of contributes to the one at @p at. The outermost
    /// voxels also have the weights of those beyond the border, if they are continued there.
    [[nodiscard]] std::uint32_t weight(int of, int at) const
    {
        std::uint32_t its =
            of < at ? m_weights[std::size_t(at - of)] : m_weights[std::size_t(of - at)];
        if (of == 0 && m_goesOnBefore)
            its += from(at + 1);
        if (of == m_length - 1 && m_goesOnBehind)
            its += from(m_length - at);
        return its;
    }
    /// The sum of all weights up to a step, which may be negative.
    [[nodiscard]] std::uint32_t upTo(int step) const
    {
        return step < 0 ? from(-step) : GridGaussian::whole - from(step + 1);
    }
    [[nodiscard]] bool goesOnBefore() const { return m_goesOnBefore; }
    [[nodiscard]] bool goesOnBehind() const { return m_goesOnBehind; }

private:
    [[nodiscard]] int reach() const { return int(m_weights.size()) - 1; }
    /// The sum of all weights from a positive step on.
    [[nodiscard]] std::uint32_t from(int step) const
    {
        return m_from[std::min(std::size_t(step), m_weights.size())];
    }

    const std::vector<std::uint32_t>& m_weights;
    int m_length;
    bool m_goesOnBefore;
    bool m_goesOnBehind;
    std::vector<std::uint32_t> m_from;
};

/// Blurs rows of a mask along x. To each voxel, a run of the mask adds the sum of all weights up to
/// the step from its beginning to the voxel, less that up to the step from its end.
class RowBlur {
public:
    explicit RowBlur(const AxisWeights& axis, int width)
        : m_axis(axis)
        , m_width(width)
        , m_upTo(2 * std::size_t(width) + 1)
    {
        for (int step = -width; step <= width; ++step)
            m_upTo[std::size_t(step + width)] = axis.upTo(step);
    }

    void blur(const std::uint8_t* row, std::uint16_t* into) const
    {
        std::vector<std::uint32_t> sums(std::size_t(m_width), 0);
        for (int x = 0; x < m_width;) {
            const int begin = x;
            while (x < m_width && row[x] != 0)
                ++x;
            if (x > begin)
                addRun(sums, begin, x);
            else
                ++x;
        }
        for (int x = 0; x < m_width; ++x)
            into[x] = std::uint16_t((sums[std::size_t(x)] + 1) / 2);
    }

private:
    /// Weights are symmetric, so steps may be counted from the run to the voxel instead of from the
    /// voxel to the run.
    void addRun(std::vector<std::uint32_t>& sums, int begin, int end) const
    {
        const bool isEndless = begin == 0 && m_axis.goesOnBefore();
        const bool hasNoEnd = end == m_width && m_axis.goesOnBehind();
        const std::uint32_t* sinceBegin = &m_upTo[std::size_t(m_width - begin)];
        const std::uint32_t* sinceEnd = &m_upTo[std::size_t(m_width - end)];
        for (int x = 0; x < m_width; ++x)
            sums[std::size_t(x)] +=
                (isEndless ? GridGaussian::whole : sinceBegin[x]) - (hasNoEnd ? 0 : sinceEnd[x]);
    }

    const AxisWeights& m_axis;
    int m_width;
    std::vector<std::uint32_t> m_upTo; ///< from the step −width on
};

/// Blurs across rows: each row of the result is a weighted sum of the given rows.
/// @param rows the given rows, each of @p width values
/// @param into returns where a row of the result is to be written
template <class Into, class Stop>
void blurAcross(const std::vector<std::uint16_t>& rows, int width, int length,
    const AxisWeights& axis, const Into& into, const Stop& stop)
{
    const auto rowAt = [&](int row) { return &rows[std::size_t(row) * std::size_t(width)]; };
    std::vector<char> isEmpty(std::size_t(length), 0);
    for (int row = 0; row < length; ++row)
        isEmpty[std::size_t(row)] = std::all_of(
            rowAt(row), rowAt(row) + width, [](std::uint16_t value) { return value == 0; });
    std::vector<std::uint32_t> sums(std::size_t(width), 0);
    for (int at = 0; at < length; ++at) {
        if (stop())
            return;
        std::fill(sums.begin(), sums.end(), GridGaussian::whole / 2);
        for (int of = axis.first(at); of <= axis.last(at); ++of) {
            if (isEmpty[std::size_t(of)] != 0)
                continue;
            const std::uint32_t weight = axis.weight(of, at);
            const std::uint16_t* row = rowAt(of);
            for (int x = 0; x < width; ++x)
                sums[std::size_t(x)] += weight * row[x];
        }
        std::uint16_t* result = into(at);
        for (int x = 0; x < width; ++x)
            result[x] = std::uint16_t(sums[std::size_t(x)] / GridGaussian::whole);
    }
}

} // namespace

double gaussianBytes(const glm::ivec3& size)
{
    const double rows = double(size.y) * double(size.z);
    constexpr double threads = 64.0;
    const double slice = double(size.x) * std::max(double(size.y), double(size.z));
    return 3.0 * double(size.x) * rows + 2.0 * std::min(threads, rows) * slice;
}

Result<BoxValues> blurred(const ByteMask& mask, const GridGaussian& gaussian, const ImageEnds& ends,
    const FilterStage& stage)
{
    const glm::ivec3& size = mask.size;
    const auto width = std::size_t(size.x);
    const auto slice = width * std::size_t(size.y);
    BoxValues box{.size = size, .values = std::vector<std::uint16_t>(mask.voxels.size())};
    const AxisWeights alongX(gaussian.weights[0], size.x, ends.before.x, ends.behind.x);
    const AxisWeights alongY(gaussian.weights[1], size.y, ends.before.y, ends.behind.y);
    const AxisWeights alongZ(gaussian.weights[2], size.z, ends.before.z, ends.behind.z);
    const RowBlur rows(alongX, size.x);
    StageCounter counter(stage, std::int64_t(size.y) + size.z);
    const auto stop = [&] { return counter.cancelled(); };

    parallelFor(size.z, [&](int z) {
        if (stop())
            return;
        std::vector<std::uint16_t> before(slice);
        for (int y = 0; y < size.y; ++y) {
            const std::size_t row = std::size_t(y) * width;
            rows.blur(&mask.voxels[std::size_t(z) * slice + row], &before[row]);
        }
        blurAcross(
            before, size.x, size.y, alongY,
            [&](int y) { return &box.values[std::size_t(z) * slice + std::size_t(y) * width]; },
            stop);
        counter.stepDone();
    });
    parallelFor(size.y, [&](int y) {
        if (stop())
            return;
        std::vector<std::uint16_t> before(width * std::size_t(size.z));
        for (int z = 0; z < size.z; ++z)
            std::copy_n(&box.values[std::size_t(z) * slice + std::size_t(y) * width], width,
                &before[std::size_t(z) * width]);
        blurAcross(
            before, size.x, size.z, alongZ,
            [&](int z) { return &box.values[std::size_t(z) * slice + std::size_t(y) * width]; },
            stop);
        counter.stepDone();
    });
    if (stop())
        return failure(ErrorCode::Cancelled);
    return box;
}

} // namespace core
