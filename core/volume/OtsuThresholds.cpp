// SPDX-License-Identifier: Apache-2.0
#include "core/volume/OtsuThresholds.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

/// The bins that are not empty, with the sums over all bins before each of them.
class FilledBins {
public:
    explicit FilledBins(std::span<const std::uint32_t> counts)
    {
        std::uint64_t total = 0;
        for (const std::uint32_t count : counts)
            total += count;
        int up = 0;
        int down = 0;
        constexpr std::uint64_t aim = std::uint64_t(1) << 31;
        while (total != 0 && total << (up + 1) <= aim)
            ++up;
        while (total >> down > aim)
            ++down;
        m_voxels.push_back(0);
        m_sums.push_back(0);
        for (std::size_t bin = 0; bin < counts.size(); ++bin) {
            if (counts[bin] == 0)
                continue;
            const std::uint64_t count =
                std::max<std::uint64_t>(std::uint64_t(counts[bin]) << up >> down, 1);
            m_bins.push_back(bin);
            m_voxels.push_back(m_voxels.back() + count);
            m_sums.push_back(m_sums.back() + bin * count);
        }
    }
    [[nodiscard]] std::size_t size() const { return m_bins.size(); }
    [[nodiscard]] std::size_t bin(std::size_t place) const { return m_bins[place]; }

    /// ⌊S² / W⌋ of the filled bins from one place to before another, by S = W · mean + rest.
    [[nodiscard]] std::uint64_t score(std::size_t from, std::size_t to) const
    {
        const std::uint64_t voxels = m_voxels[to] - m_voxels[from];
        const std::uint64_t sum = m_sums[to] - m_sums[from];
        const std::uint64_t mean = sum / voxels;
        const std::uint64_t rest = sum % voxels;
        return voxels * mean * mean + 2 * mean * rest + rest * rest / voxels;
    }

private:
    std::vector<std::size_t> m_bins;
    std::vector<std::uint64_t> m_voxels; ///< in the bins before each place
    std::vector<std::uint64_t> m_sums;
};

} // namespace

std::vector<std::size_t> otsuBins(std::span<const std::uint32_t> counts, int thresholds)
{
    const FilledBins filled(counts);
    const std::size_t size = filled.size();
    const std::size_t parts = std::min(std::size_t(std::max(thresholds, 0)) + 1, size);
    if (parts < 2)
        return {};
    // For divisions of the bins before each place into the present number of parts: the best sum of
    // scores, and where its last part begins.
    std::vector<std::uint64_t> best(size + 1, 0);
    for (std::size_t end = 1; end <= size; ++end)
        best[end] = filled.score(0, end);
    std::vector<std::vector<std::size_t>> begins;
    for (std::size_t count = 2; count <= parts; ++count) {
        std::vector<std::uint64_t> next(size + 1, 0);
        std::vector<std::size_t>& begin = begins.emplace_back(size + 1, 0);
        for (std::size_t end = count; end <= size; ++end) {
            for (std::size_t from = count - 1; from < end; ++from) {
                const std::uint64_t sum = best[from] + filled.score(from, end);
                if (from == count - 1 || sum > next[end]) {
                    next[end] = sum;
                    begin[end] = from;
                }
            }
        }
        best = std::move(next);
    }
    std::vector<std::size_t> bins;
    std::size_t end = size;
    for (auto begin = begins.rbegin(); begin != begins.rend(); ++begin) {
        end = (*begin)[end];
        bins.push_back((filled.bin(end - 1) + filled.bin(end) + 1) / 2);
    }
    std::reverse(bins.begin(), bins.end());
    return bins;
}

std::vector<double> otsuThresholds(const Histogram& histogram, int thresholds)
{
    const double width = (histogram.maximum - histogram.minimum)
        / double(std::max<std::size_t>(histogram.counts.size(), 1));
    std::vector<double> values;
    for (const std::size_t bin : otsuBins(histogram.counts, thresholds))
        values.push_back(histogram.minimum + double(bin) * width);
    return values;
}

} // namespace core
