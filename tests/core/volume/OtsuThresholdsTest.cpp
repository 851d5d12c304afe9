// SPDX-License-Identifier: Apache-2.0
#include "core/volume/OtsuThresholds.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <random>

namespace otsuThresholdsTest {

using namespace core;

namespace {

using Counts = std::vector<std::uint32_t>;
using Bins = std::vector<std::size_t>;

/// Otsu's own words: how far the means of the parts lie from the mean of all. Less than 0 where a
/// part is empty.
double varianceBetween(const Counts& counts, const Bins& bins)
{
    double all = 0.0;
    double sum = 0.0;
    for (std::size_t bin = 0; bin < counts.size(); ++bin) {
        all += counts[bin];
        sum += double(bin) * counts[bin];
    }
    double variance = 0.0;
    for (std::size_t part = 0; part <= bins.size(); ++part) {
        const std::size_t from = part == 0 ? 0 : bins[part - 1];
        const std::size_t to = part == bins.size() ? counts.size() : bins[part];
        double voxels = 0.0;
        double own = 0.0;
        for (std::size_t bin = from; bin < to; ++bin) {
            voxels += counts[bin];
            own += double(bin) * counts[bin];
        }
        if (voxels == 0.0)
            return -1.0;
        const double away = own / voxels - sum / all;
        variance += voxels / all * away * away;
    }
    return variance;
}

/// Every way there is.
double greatestVariance(const Counts& counts, Bins& bins, int thresholds)
{
    if (thresholds == 0)
        return varianceBetween(counts, bins);
    double greatest = -1.0;
    for (std::size_t bin = bins.empty() ? 1 : bins.back() + 1; bin < counts.size(); ++bin) {
        bins.push_back(bin);
        greatest = std::max(greatest, greatestVariance(counts, bins, thresholds - 1));
        bins.pop_back();
    }
    return greatest;
}

Counts randomCounts(std::mt19937& random)
{
    Counts counts(2 + random() % 22);
    // From a handful of voxels to more than fit into 32 bits together.
    const std::uint32_t most = std::uint32_t(1) << random() % 32;
    const bool sparse = random() % 2;
    for (std::uint32_t& count : counts)
        count = sparse && random() % 3 ? 0 : std::uint32_t(random()) % most + (random() % 2);
    return counts;
}

} // namespace

/// Thresholds of a histogram, held to every way of parting it.
class OtsuThresholdsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void noWayIsBetter_data()
    {
        QTest::addColumn<int>("thresholds");
        for (const int thresholds : {1, 2, 3})
            QTest::addRow("%d", thresholds) << thresholds;
    }
    void noWayIsBetter()
    {
        QFETCH(const int, thresholds);
        std::mt19937 random(std::uint32_t(40 + thresholds));
        int compared = 0;
        for (int number = 0; number < 400; ++number) {
            const Counts counts = randomCounts(random);
            const auto filled = std::count_if(
                counts.begin(), counts.end(), [](std::uint32_t count) { return count > 0; });
            const Bins found = otsuBins(counts, thresholds);
            QCOMPARE(
                found.size(), std::size_t(std::clamp<std::ptrdiff_t>(filled - 1, 0, thresholds)));
            QVERIFY(std::is_sorted(found.begin(), found.end()));
            if (found.empty())
                continue;
            Bins none;
            const double best = greatestVariance(counts, none, int(found.size()));
            const double reached = varianceBetween(counts, found);
            QVERIFY2(reached >= best * (1.0 - 1e-6),
                qPrintable(QStringLiteral("%1: %2 of %3").arg(number).arg(reached).arg(best)));
            ++compared;
        }
        QVERIFY(compared > 200);
    }

    void betweenHeaps()
    {
        Counts counts(100, 0);
        for (const std::size_t heap : {10, 40, 70, 90}) {
            for (std::size_t bin = heap - 2; bin <= heap + 2; ++bin)
                counts[bin] = 1000;
        }
        // In the middle of what is empty: 13 … 37, 43 … 67, 73 … 87.
        QCOMPARE(otsuBins(counts, 3), (Bins{25, 55, 80}));
        const Histogram histogram{.minimum = -1000.0, .maximum = 1000.0, .counts = counts};
        QCOMPARE(otsuThresholds(histogram, 3), (std::vector<double>{-500.0, 100.0, 600.0}));
        QCOMPARE(otsuBins(counts, 1), (Bins{55}));
    }

    void whatCannotBeParted()
    {
        QVERIFY(otsuBins({}, 2).empty());
        QVERIFY(otsuBins(Counts{0, 0, 0}, 1).empty());
        QVERIFY(otsuBins(Counts{0, 7, 0}, 3).empty());
        QVERIFY(otsuBins(Counts{4, 7, 1}, 0).empty());
        QCOMPARE(otsuBins(Counts{5, 0, 0, 5}, 3), (Bins{2}));
        QCOMPARE(otsuBins(Counts{1, 1, 1}, 3), (Bins{1, 2}));
        QVERIFY(otsuThresholds(Histogram{}, 2).empty());
    }

    /// A few voxels among very many are neither lost nor too many.
    void fullHistograms()
    {
        Counts counts(256, UINT32_MAX);
        QCOMPARE(otsuBins(counts, 1), (Bins{128}));
        QCOMPARE(otsuBins(counts, 3), (Bins{64, 128, 192}));
        std::fill(counts.begin(), counts.end(), 0);
        counts[3] = UINT32_MAX;
        counts[200] = 1;
        QCOMPARE(otsuBins(counts, 2), (Bins{102}));
    }
};

BURIN_TEST(OtsuThresholdsTest)

} // namespace otsuThresholdsTest

#include "OtsuThresholdsTest.moc"
