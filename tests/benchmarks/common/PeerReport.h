// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace bench {

/// Gathers Google Benchmark's repetitions and pairs Burin's with each peer's.
///
/// A benchmark is named "id/who": "frame.mip/burin", "frame.mip/VTK GPU mapper". Figures that are
/// no times (bytes), or that no peer has, are added as they are.
class PeerReport : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context& context) override;
    void ReportRuns(const std::vector<Run>& runs) override;

    struct Figure {
        std::string id;
        std::string unit; ///< "Ms", "Bytes"
        double ours = 0.0;
        std::string peer{}; ///< empty: nobody to compare with
        double theirs = 0.0;
    };
    void add(Figure figure) { m_figures.push_back(std::move(figure)); }

    void printTable() const;
    /// [{"id","peer","oursMs","peerMs","ratio"}], ratio = peer / ours; "oursBytes", "peerBytes" for
    /// sizes; no peer and no ratio where there is none
    void printJson() const;

    static constexpr const char* ours = "burin";

private:
    [[nodiscard]] std::vector<Figure> figures() const;

    std::vector<Figure> m_figures; ///< that were added
    std::vector<std::string> m_ids; ///< of benchmarks, in the order they came
    std::map<std::string, std::map<std::string, std::vector<double>>> m_milliseconds; ///< id, who
};

} // namespace bench
