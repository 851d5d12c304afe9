// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/common/PeerReport.h"

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

std::vector<PeerReport::Figure> PeerReport::figures() const
{
    std::vector<Figure> figures;
    for (const std::string& id : m_ids) {
        const auto& times = m_milliseconds.at(id);
        const auto own = times.find(ours);
        if (own == times.end())
            continue;
        for (const auto& [who, milliseconds] : times) {
            if (who != ours)
                figures.push_back({id, "Ms", median(own->second), who, median(milliseconds)});
        }
        if (times.size() == 1)
            figures.push_back({id, "Ms", median(own->second)});
    }
    std::sort(figures.begin(), figures.end(), [](const Figure& a, const Figure& b) {
        return std::tie(a.id, a.peer) < std::tie(b.id, b.peer);
    });
    figures.insert(figures.end(), m_figures.begin(), m_figures.end());
    return figures;
}

void PeerReport::printTable() const
{
    std::printf("%-36s %-30s %5s %14s %14s %9s\n", "work", "peer", "", "Burin", "peer", "ratio");
    for (const Figure& figure : figures()) {
        const int decimals = figure.unit == "Bytes" ? 0 : 2;
        std::printf("%-36s %-30s %5s %14.*f", figure.id.c_str(), figure.peer.c_str(),
            figure.unit.c_str(), decimals, figure.ours);
        if (!figure.peer.empty())
            std::printf(" %14.*f %8.2fx", decimals, figure.theirs, figure.theirs / figure.ours);
        std::printf("\n");
    }
}

void PeerReport::printJson() const
{
    const char* separator = "[";
    for (const Figure& figure : figures()) {
        std::printf(R"(%s{"id":"%s","ours%s":%.3f)", separator, figure.id.c_str(),
            figure.unit.c_str(), figure.ours);
        if (!figure.peer.empty())
            std::printf(R"(,"peer":"%s","peer%s":%.3f,"ratio":%.3f)", figure.peer.c_str(),
                figure.unit.c_str(), figure.theirs, figure.theirs / figure.ours);
        std::printf("}");
        separator = ",\n ";
    }
    std::printf("%s]\n", separator[0] == '[' ? "[" : "");
}

} // namespace bench
