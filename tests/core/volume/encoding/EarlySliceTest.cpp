// SPDX-License-Identifier: Apache-2.0
#include "core/study/StudyLoader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/SyntheticSeries.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>

namespace earlySliceTest {

using test::SyntheticSeries;

namespace {

/// What the loader told on its way, and what it came to.
struct Told {
    std::vector<std::shared_ptr<const core::EarlySlice>> slices;
    core::Result<core::LoadedVolume> loaded;
};

Told load(const QString& path, const QString& series = {})
{
    const core::Result<core::Study> study = core::Study::scan(path);
    if (!study)
        return {{}, tl::unexpected(study.error())};
    Told told;
    told.loaded = study->load(
        series, core::Progress(), [&told](const std::shared_ptr<const core::EarlySlice>& early) {
            told.slices.push_back(early);
        });
    return told;
}

void giveWindow(DcmDataset& set)
{
    set.putAndInsertString(DCM_WindowCenter, "-300");
    set.putAndInsertString(DCM_WindowWidth, "1200");
}

SyntheticSeries windowed(const char* syntax = "1.2.840.10008.1.2.1")
{
    SyntheticSeries series;
    series.transferSyntaxUid = QString::fromLatin1(syntax);
    series.adjust = [](DcmDataset& set, int) { giveWindow(set); };
    return series;
}

/// The largest difference between an early slice and the same one of the finished volume.
double worstError(const core::EarlySlice& early, const core::LoadedVolume& loaded)
{
    const glm::ivec3& size = loaded.volume.geometry.size;
    double worst = 0.0;
    for (int j = 0; j < size.y; ++j) {
        for (int i = 0; i < size.x; ++i) {
            const int code = early.codes.at(std::size_t(j) * std::size_t(size.x) + std::size_t(i));
            const double off =
                early.volume.encoding.value(code) - test::valueAt(loaded, {i, j, early.slice});
            worst = std::max(worst, std::abs(off));
        }
    }
    return worst;
}

/// Says why not.
QString differenceOf(const core::EarlySlice& early, const core::LoadedVolume& loaded)
{
    const core::Volume& is = loaded.volume;
    if (early.volume.geometry.size != is.geometry.size
        || early.volume.geometry.indexToWorld != is.geometry.indexToWorld)
        return QStringLiteral("geometry");
    if (early.slice != is.geometry.size.z / 2)
        return QStringLiteral("not the middle");
    if (!(early.volume.defaultWindow == is.defaultWindow))
        return QStringLiteral("window");
    if (early.volume.displayInverted != is.displayInverted)
        return QStringLiteral("inverted");
    if (early.volume.unit != is.unit || early.volume.identity.patientName != is.identity.patientName
        || early.volume.problems.size() != is.problems.size())
        return QStringLiteral("what is written over it");
    return {};
}

} // namespace

/// The slice that is told of before the volume is there.
class EarlySliceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void isThatOfTheVolume_data();
    void isThatOfTheVolume();
    void scaleOfItsOwnIsExact();
    void sharedSeries();
    void notWhereItWouldLookOtherwise();
    void notOfADamagedSlice();
    void othersThatFailAreLeftOut();
    void cancelledAfterItIsCancelled();

private:
    [[nodiscard]] QString path() const { return m_folder->filePath(QStringLiteral("series")); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void EarlySliceTest::isThatOfTheVolume_data()
{
    QTest::addColumn<QString>("syntax");
    QTest::addColumn<int>("bitsStored");
    QTest::addColumn<bool>("isSigned");
    QTest::addColumn<double>("slope");
    QTest::addColumn<int>("slices");
    const auto add = [](const char* name, const char* syntax, int bits, bool isSigned, double slope,
                         int slices) {
        QTest::newRow(name) << QString::fromLatin1(syntax) << bits << isSigned << slope << slices;
    };
    add("implicit", "1.2.840.10008.1.2", 12, false, 1.0, 10);
    add("explicit", "1.2.840.10008.1.2.1", 12, false, 1.0, 11);
    add("signed", "1.2.840.10008.1.2.1", 12, true, 1.0, 10);
    add("all 16 bits", "1.2.840.10008.1.2.1", 16, false, 1.0, 10);
    add("all 16 bits, signed", "1.2.840.10008.1.2.1", 16, true, 1.0, 10);
    add("falling", "1.2.840.10008.1.2.1", 12, false, -2.5, 10);
    add("falling, signed", "1.2.840.10008.1.2.1", 16, true, -0.125, 10);
    add("deflated", "1.2.840.10008.1.2.1.99", 12, false, 1.0, 10);
    add("big endian", "1.2.840.10008.1.2.2", 12, false, 1.0, 10);
    add("RLE", "1.2.840.10008.1.2.5", 12, false, 1.0, 10);
    add("JPEG lossless", "1.2.840.10008.1.2.4.70", 12, false, 1.0, 10);
    add("JPEG lossless, signed", "1.2.840.10008.1.2.4.70", 16, true, 1.0, 10);
    add("JPEG-LS", "1.2.840.10008.1.2.4.80", 12, false, 1.0, 10);
    add("two slices", "1.2.840.10008.1.2.1", 12, false, 1.0, 2);
}

void EarlySliceTest::isThatOfTheVolume()
{
    QFETCH(QString, syntax);
    QFETCH(int, bitsStored);
    QFETCH(bool, isSigned);
    QFETCH(double, slope);
    QFETCH(int, slices);
    SyntheticSeries series = windowed(qPrintable(syntax));
    series.size.z = slices;
    series.layout.bitsStored = bitsStored;
    series.layout.highBit = bitsStored - 1;
    series.layout.isSigned = isSigned;
    series.slope = [slope](int) { return slope; };
    series.stored = [isSigned](const glm::ivec3& at) {
        return SyntheticSeries::defaultStored(at) - (isSigned ? 1024 : 0);
    };
    test::writeSeries(series, path());
    const Told told = load(path());
    QVERIFY2(told.loaded, told.loaded ? "" : qPrintable(test::errorText(told.loaded.error())));
    QCOMPARE(test::worstError(*told.loaded, series), 0.0);
    QCOMPARE(told.slices.size(), std::size_t(1));
    QCOMPARE(differenceOf(*told.slices.front(), *told.loaded), QString());
    QCOMPARE(worstError(*told.slices.front(), *told.loaded), 0.0);
}

/// The volume's values are on a common scale then, and near; the slice's are its own.
void EarlySliceTest::scaleOfItsOwnIsExact()
{
    SyntheticSeries series = windowed();
    series.slope = [](int k) { return 0.25 + 0.01 * k; };
    test::writeSeries(series, path());
    const Told told = load(path());
    QVERIFY(told.loaded);
    QCOMPARE(told.slices.size(), std::size_t(1));
    const core::EarlySlice& early = *told.slices.front();
    QVERIFY(told.loaded->volume.encoding.maxError > 0.0);
    QVERIFY(worstError(early, *told.loaded) <= told.loaded->volume.encoding.maxError);
    for (int i = 0; i < series.size.x; ++i)
        QCOMPARE(early.volume.encoding.value(early.codes[std::size_t(i)]),
            series.value({i, 0, early.slice}));
}

void EarlySliceTest::sharedSeries()
{
    if (test::sharedDataFolder().isEmpty())
        QSKIP("no shared data");
    int told = 0;
    for (const char* name : {"edge_transfer_syntaxes", "edge_pixels_colour", "edge_multiframe",
             "ct_abdomen_j2k_organs", "mr_multifragment_jpegll", "ct_tilt_study_philips"}) {
        const test::SharedCase shared = test::sharedCase(QString::fromLatin1(name));
        const QString& folder = shared.unpacked.isEmpty() ? shared.source : shared.unpacked;
        const core::Result<core::Study> study = core::Study::scan(folder);
        QVERIFY2(study, name);
        for (const core::StudyEntry& entry : study->listing().studies) {
            for (const core::SeriesEntry& series : entry.series) {
                std::shared_ptr<const core::EarlySlice> early;
                const auto loaded = study->load(series.key, core::Progress(),
                    [&early](
                        const std::shared_ptr<const core::EarlySlice>& slice) { early = slice; });
                if (!loaded || !early)
                    continue;
                const bool whole = loaded->volume.geometry.size == series.geometry.size;
                if (!whole) // slices were left out
                    continue;
                ++told;
                const QString wrong = differenceOf(*early, *loaded);
                QVERIFY2(wrong.isEmpty(), qPrintable(series.line() + wrong));
                QVERIFY2(worstError(*early, *loaded) <= loaded->volume.encoding.maxError,
                    qPrintable(series.line()));
            }
        }
    }
    QVERIFY2(told >= 10, qPrintable(QString::number(told)));
}

void EarlySliceTest::notWhereItWouldLookOtherwise()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    const Told unwindowed = load(path());
    QVERIFY(unwindowed.loaded);
    QVERIFY(unwindowed.slices.empty());

    series = windowed();
    series.step = {0.0, 0.4, 2.5};
    const QString tilted = m_folder->filePath(QStringLiteral("tilted"));
    test::writeSeries(series, tilted);
    const Told repaired = load(tilted, series.seriesUid + QStringLiteral("+tilt"));
    QVERIFY2(repaired.loaded,
        repaired.loaded ? "" : qPrintable(test::errorText(repaired.loaded.error())));
    QVERIFY(repaired.slices.empty());
    QCOMPARE(load(tilted, series.seriesUid).slices.size(), std::size_t(1));
}

void EarlySliceTest::notOfADamagedSlice()
{
    const SyntheticSeries series = windowed("1.2.840.10008.1.2.5");
    QFile middle(test::writeSeries(series, path())[series.size.z / 2]);
    // Not to be seen before it is decoded: RLE that does nothing for so long.
    constexpr int damaged = 150;
    constexpr int endOfSequence = 8;
    QVERIFY(middle.open(QIODevice::ReadWrite));
    QVERIFY(middle.seek(middle.size() - endOfSequence - damaged));
    QCOMPARE(middle.write(QByteArray(damaged, '\x80')), qint64(damaged));
    middle.close();
    const Told told = load(path());
    QVERIFY(told.loaded);
    QVERIFY(told.slices.empty());
    QCOMPARE(told.loaded->volume.geometry.size.z, series.size.z - 1);
}

void EarlySliceTest::othersThatFailAreLeftOut()
{
    const SyntheticSeries series = windowed("1.2.840.10008.1.2.4.70");
    QFile last(test::writeSeries(series, path()).back());
    QVERIFY(last.resize(last.size() - 100));
    const Told told = load(path());
    QVERIFY(told.loaded);
    QCOMPARE(told.slices.size(), std::size_t(1));
    // The rest is what it is without the one that failed, to the checksum.
    QVERIFY(last.remove());
    const core::LoadedVolume rest = test::openVolume(path());
    QCOMPARE(told.loaded->volume.voxelsSha256, rest.volume.voxelsSha256);
    QCOMPARE(told.loaded->codes, rest.codes);
}

void EarlySliceTest::cancelledAfterItIsCancelled()
{
    const SyntheticSeries series = windowed();
    test::writeSeries(series, path());
    const core::Result<core::Study> study = core::Study::scan(path());
    QVERIFY(study);
    core::Progress progress;
    int told = 0;
    const auto loaded = study->load({}, progress, [&](const auto&) {
        ++told;
        progress.cancel();
    });
    QCOMPARE(told, 1);
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, core::ErrorCode::Cancelled);
}

BURIN_TEST(EarlySliceTest)

} // namespace earlySliceTest

#include "EarlySliceTest.moc"
