// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/PeerReport.h"

#include <algorithm>
#include <cstdio>

namespace bench {

namespace {

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 != 0 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

} // namespace

bool PeerReport::ReportContext(const Context&)
{
    return true;
}

void PeerReport::ReportRuns(const std::vector<Run>& runs)
{
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration || run.error_occurred)
            continue;
        const std::string& name = run.run_name.function_name;
        const std::size_t slash = name.find('/');
        const std::string id = name.substr(0, slash);
        if (m_milliseconds.find(id) == m_milliseconds.end())
            m_ids.push_back(id);
        m_milliseconds[id][name.substr(slash + 1)].push_back(
            1000.0 * run.real_accumulated_time / double(run.iterations));
    }
}

std::vector<PeerReport::Pair> PeerReport::pairs() const
{
    std::vector<Pair> pairs;
    for (const std::string& id : m_ids) {
        const auto& times = m_milliseconds.at(id);
        const auto own = times.find(ours);
        for (const auto& [who, milliseconds] : times) {
            if (who != ours && own != times.end())
                pairs.push_back({id, who, median(own->second), median(milliseconds)});
        }
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
        return std::tie(a.id, a.peer) < std::tie(b.id, b.peer);
    });
    return pairs;
}

void PeerReport::printTable() const
{
    std::printf("%-14s %-24s %12s %12s %8s\n", "work", "peer", "Burin ms", "peer ms", "ratio");
    for (const Pair& pair : pairs())
        std::printf("%-14s %-24s %12.1f %12.1f %7.2fx\n", pair.id.c_str(), pair.peer.c_str(),
            pair.oursMs, pair.peerMs, pair.peerMs / pair.oursMs);
}

void PeerReport::printJson() const
{
    const char* separator = "[";
    for (const Pair& pair : pairs()) {
        std::printf(R"(%s{"id":"%s","peer":"%s","oursMs":%.3f,"peerMs":%.3f,"ratio":%.3f})",
            separator, pair.id.c_str(), pair.peer.c_str(), pair.oursMs, pair.peerMs,
            pair.peerMs / pair.oursMs);
        separator = ",\n ";
    }
    std::printf("%s]\n", separator[0] == '[' ? "[" : "");
}

} // namespace bench
