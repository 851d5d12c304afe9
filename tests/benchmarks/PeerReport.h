// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace bench {

/// Gathers Google Benchmark's repetitions and pairs Burin's with each peer's.
///
/// A benchmark is named "id/who": "frame.mip/burin", "frame.mip/VTK GPU mapper".
class PeerReport : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context& context) override;
    void ReportRuns(const std::vector<Run>& runs) override;

    void printTable() const;
    void printJson() const; ///< [{"id","peer","oursMs","peerMs","ratio"}], ratio = peer / ours

    static constexpr const char* ours = "burin";

private:
    struct Pair {
        std::string id;
        std::string peer;
        double oursMs = 0.0;
        double peerMs = 0.0;
    };
    [[nodiscard]] std::vector<Pair> pairs() const;

    std::vector<std::string> m_ids; ///< in the order they came
    std::map<std::string, std::map<std::string, std::vector<double>>> m_milliseconds; ///< id, who
};

} // namespace bench
