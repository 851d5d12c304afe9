// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/pacing/PacingRecord.h"

#include <QJsonObject>

#include <algorithm>
#include <map>

namespace bench {

namespace {

/// @param share of those that are not longer
double percentile(std::vector<double> sorted, double share)
{
    std::sort(sorted.begin(), sorted.end());
    return sorted[std::size_t(share * double(sorted.size() - 1) + 0.5)];
}

QJsonObject figure(const QString& id, double milliseconds)
{
    return {{QStringLiteral("id"), QStringLiteral("pacing.%1").arg(id)},
        {QStringLiteral("oursMs"), milliseconds}};
}

} // namespace

std::vector<PacingRecord::Wait> PacingRecord::waits(const Phase& phase) const
{
    std::vector<Wait> found;
    double last = phase.begin;
    double longest = 0.0;
    for (const Picture& picture : pictures) {
        if (picture.view != phase.view || picture.at < phase.begin || picture.at >= phase.end)
            continue;
        found.push_back({.at = picture.at, .lasted = picture.at - last});
        longest = std::max(longest, picture.at - last);
        last = picture.at;
    }
    if (found.empty() || phase.end - last > longest)
        found.push_back({.at = phase.end, .lasted = phase.end - last});
    return found;
}

PacingRecord::Gap PacingRecord::longestGap() const
{
    const auto longest = std::max_element(
        gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.lasted < b.lasted; });
    return longest == gaps.end() ? Gap() : *longest;
}

QString PacingRecord::phaseAt(double at) const
{
    for (const Phase& phase : phases) {
        if (at >= phase.begin && at < phase.end)
            return phase.id;
    }
    return {};
}

QJsonArray PacingRecord::figures() const
{
    QJsonArray figures;
    for (const Phase& phase : phases) {
        std::vector<double> times;
        for (const Wait& wait : waits(phase))
            times.push_back(wait.lasted);
        figures += figure(phase.id, percentile(times, 0.5));
        figures += figure(phase.id + QStringLiteral(".p95"), percentile(times, 0.95));
        figures += figure(phase.id + QStringLiteral(".worst"), percentile(times, 1.0));
    }
    figures += figure(QStringLiteral("longestStall"), longestGap().lasted);
    return figures;
}

QByteArray PacingRecord::csv() const
{
    struct Line {
        double at;
        QString text;
    };
    std::vector<Line> lines;
    const auto number = [](double value) { return QString::number(value, 'f', 2); };
    std::map<QString, double> last;
    for (const Picture& picture : pictures) {
        const auto before = last.find(picture.view);
        const QString since =
            before == last.end() ? QString() : number(picture.at - before->second);
        lines.push_back({picture.at,
            QStringLiteral("picture,%1,%2,%3,%4,%5,")
                .arg(number(picture.at), phaseAt(picture.at), since, picture.view,
                    picture.quality)});
        last[picture.view] = picture.at;
    }
    for (const Gap& gap : gaps)
        lines.push_back({gap.begin,
            QStringLiteral("gap,%1,%2,%3,,,\"%4\"")
                .arg(number(gap.begin), phaseAt(gap.begin), number(gap.lasted), gap.name)});
    std::stable_sort(
        lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.at < b.at; });
    QString text = QStringLiteral("kind,at ms,phase,lasted ms,view,quality,longest event\n");
    for (const Line& line : lines)
        text += line.text + QLatin1Char('\n');
    return text.toUtf8();
}

} // namespace bench
