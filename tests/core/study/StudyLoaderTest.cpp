// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/SyntheticSeries.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <memory>

namespace studyLoaderTest {

using core::VolumeProblem;
using test::SyntheticSeries;

/// Series made to order: whatever their defects, they open as what they are, or with one clear
/// word.
class StudyLoaderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void identityAndSources();
    void frameOfReferenceIsSharedOrNone();
    void localizerInsideASeriesIsApart();
    void foreignObjectsAreNoError();
    void missingUidsGetAStableName();
    void unknownTransferSyntaxIsNamed();
    void seriesIsChosenNotGuessed();
    void cutSliceIsLeftOutAndNamed();
    void aSliceThatFailsLeavesOtherCautions();
    void badPathsAreClear();
    void cancelStops();
    void nestedSequencesAreRefused();
    void multiFrameIsReported();
    void directoryFileStandsForItsFolder();

private:
    [[nodiscard]] QString path(const QString& name = QStringLiteral("series")) const
    {
        return m_folder->filePath(name);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void StudyLoaderTest::identityAndSources()
{
    SyntheticSeries series;
    series.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 100");
        set.putAndInsertString(DCM_PatientName, "M\xfcller^J\xf6rg");
    };
    const QStringList files = test::writeSeries(series, path());
    const core::LoadedVolume loaded = test::openVolume(path());
    const core::StudyIdentity& identity = loaded.volume.identity;
    QCOMPARE(identity.patientName, QStringLiteral("Müller^Jörg"));
    QCOMPARE(identity.patientId, QStringLiteral("SYN1"));
    QCOMPARE(identity.birthDate, QStringLiteral("1970-01-02"));
    QCOMPARE(identity.studyDate, QStringLiteral("2024-01-31"));
    QCOMPARE(identity.seriesUid, series.seriesUid);
    QCOMPARE(identity.modality, QStringLiteral("CT"));
    QCOMPARE(loaded.volume.sources.size(), std::size_t(series.size.z));
    for (int k = 0; k < series.size.z; ++k) {
        const core::SourceSlice& source = loaded.volume.sources[std::size_t(k)];
        QCOMPARE(source.file, files[k]);
        QCOMPARE(source.instanceNumber, series.size.z - k);
        QCOMPARE(source.sopInstanceUid, QStringLiteral("%1.%2").arg(series.seriesUid).arg(k + 1));
    }
}

void StudyLoaderTest::frameOfReferenceIsSharedOrNone()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    QCOMPARE(
        test::openVolume(path()).volume.identity.frameOfReferenceUid, QStringLiteral("2.25.4713"));

    series.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(
            DCM_FrameOfReferenceUID, ("2.25.9." + QByteArray::number(k + 1)).constData());
    };
    test::writeSeries(series, path(QStringLiteral("each its own")));
    const core::LoadedVolume loaded = test::openVolume(path(QStringLiteral("each its own")));
    QCOMPARE(test::worstError(loaded, series), 0.0);
    QCOMPARE(loaded.volume.identity.frameOfReferenceUid, QString());
    QVERIFY(!loaded.volume.problems.empty());

    series.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(DCM_FrameOfReferenceUID, k < 4 ? "2.25.5" : "2.25.6");
    };
    test::writeSeries(series, path(QStringLiteral("two")));
    const core::Result<core::StudyListing> listing = core::scanStudies(path(QStringLiteral("two")));
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(2));
}

void StudyLoaderTest::localizerInsideASeriesIsApart()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    SyntheticSeries scout = series;
    scout.size = {32, 32, 1};
    scout.plane = {{1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}};
    scout.fileName = [](int) { return QStringLiteral("scout"); };
    scout.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_ImageType, "ORIGINAL\\PRIMARY\\LOCALIZER");
    };
    test::writeSeries(scout, path());
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    QCOMPARE(listing->foreign.size(), std::size_t(1));
    QCOMPARE(listing->foreign.front().kind, QStringLiteral("localizer"));
    QCOMPARE(test::worstError(test::openVolume(path()), series), 0.0);
}

void StudyLoaderTest::foreignObjectsAreNoError()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    for (const char* sopClass : {"1.2.840.10008.5.1.4.1.1.66.4", "1.2.840.10008.5.1.4.1.1.481.3",
             "1.2.840.10008.5.1.4.1.1.88.22", "1.2.840.10008.5.1.4.1.1.11.1"}) {
        SyntheticSeries other = series;
        other.size.z = 1;
        other.fileName = [=](int) { return QString::fromLatin1(sopClass); };
        other.adjust = [=](DcmDataset& set, int) {
            set.putAndInsertString(DCM_SOPClassUID, sopClass);
        };
        test::writeSeries(other, path());
    }
    QFile notes(path() + QStringLiteral("/notes.txt"));
    QVERIFY(notes.open(QIODevice::WriteOnly) && notes.write("These are no pictures at all.") > 0);
    notes.close();
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(1));
    QCOMPARE(listing->foreign.size(), std::size_t(4));
    QCOMPARE(listing->unreadable.size(), std::size_t(1));
    QVERIFY(listing->unreadable.front().file.endsWith(QLatin1String("notes.txt")));
    QCOMPARE(test::worstError(test::openVolume(path()), series), 0.0);
}

void StudyLoaderTest::missingUidsGetAStableName()
{
    SyntheticSeries series;
    series.adjust = [](DcmDataset& set, int) {
        for (const DcmTagKey& key : {DCM_StudyInstanceUID, DCM_SeriesInstanceUID,
                 DCM_SOPInstanceUID, DCM_SOPClassUID, DCM_PatientName, DCM_FrameOfReferenceUID})
            set.findAndDeleteElement(key);
    };
    test::writeSeries(series, path());
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(1));
    const QString key = listing->candidates().front()->key;
    QVERIFY(!key.isEmpty());
    test::writeSeries(series, path(QStringLiteral("again")));
    const core::LoadedVolume loaded = test::openVolume(path(QStringLiteral("again")), key);
    QCOMPARE(test::worstError(loaded, series), 0.0);
    QVERIFY(loaded.volume.identity.seriesUid.isEmpty());
}

void StudyLoaderTest::unknownTransferSyntaxIsNamed()
{
    SyntheticSeries series;
    series.size.z = 2;
    for (const QString& file : test::writeSeries(series, path())) {
        // The UID of JPEG XL lossless in place of Explicit VR Little Endian.
        QFile bytes(file);
        QVERIFY(bytes.open(QIODevice::ReadWrite));
        QByteArray content = bytes.readAll();
        const qsizetype at = content.indexOf("1.2.840.10008.1.2.1");
        QVERIFY(at > 0);
        content[at + 18] = '7';
        bytes.seek(0);
        bytes.write(content);
    }
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(path());
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, core::ErrorCode::UnsupportedFormat);
    QVERIFY2(loaded.error().arguments.value(1).contains(QLatin1String("1.2.840.10008.1.2.7")),
        qPrintable(test::errorText(loaded.error())));
}

void StudyLoaderTest::seriesIsChosenNotGuessed()
{
    SyntheticSeries one;
    SyntheticSeries two;
    two.seriesUid = QStringLiteral("2.25.999");
    two.stored = [](const glm::ivec3& index) { return index.x; };
    test::writeSeries(one, path() + QStringLiteral("/one"));
    test::writeSeries(two, path() + QStringLiteral("/deeper/two"));
    const core::Result<core::LoadedVolume> guessed = core::loadVolume(path());
    QVERIFY(!guessed);
    QCOMPARE(guessed.error().code, core::ErrorCode::SeriesAmbiguous);
    QCOMPARE(guessed.error().arguments.size(), 3);
    for (const QString& line : guessed.error().arguments.mid(1)) {
        QVERIFY2(line.contains(QLatin1String("Synthetic^Subject")), qPrintable(line));
        QVERIFY2(line.contains(QLatin1String("2024-01-31")), qPrintable(line));
        QVERIFY2(line.contains(QLatin1String("Made to order")), qPrintable(line));
        QVERIFY2(line.contains(QLatin1String("10 slices")), qPrintable(line));
    }
    QCOMPARE(test::worstError(test::openVolume(path(), two.seriesUid), two), 0.0);
    QCOMPARE(test::worstError(test::openVolume(path(), one.seriesUid), one), 0.0);
    const core::Result<core::LoadedVolume> wrong =
        core::loadVolume(path(), QStringLiteral("2.25.1"));
    QVERIFY(!wrong);
    QCOMPARE(wrong.error().code, core::ErrorCode::SeriesNotFound);
}

void StudyLoaderTest::cutSliceIsLeftOutAndNamed()
{
    for (const char* syntax : {"1.2.840.10008.1.2.1", "1.2.840.10008.1.2.4.70"}) {
        const QString folder = path(QString::fromLatin1(syntax));
        SyntheticSeries series;
        series.transferSyntaxUid = QString::fromLatin1(syntax);
        const QStringList files = test::writeSeries(series, folder);
        QFile cut(files[4]);
        QVERIFY(cut.resize(cut.size() - 100));
        const core::LoadedVolume loaded = test::openVolume(folder);
        QCOMPARE(loaded.volume.geometry.size.z, series.size.z - 1);
        const QString text =
            test::problemText(loaded.volume.problems, VolumeProblem::Kind::DamagedSlice);
        QVERIFY2(text.contains(series.fileName(4)), qPrintable(text));
        QVERIFY(test::hasProblem(loaded.volume.problems, VolumeProblem::Kind::MissingSlices));
        QCOMPARE(test::valueAt(loaded, {3, 5, 4}), series.value({3, 5, 5}));
    }
}

/// What is said of the images stays, and names the places that are left.
void StudyLoaderTest::aSliceThatFailsLeavesOtherCautions()
{
    SyntheticSeries series;
    series.size.z = 5;
    series.transferSyntaxUid = QStringLiteral("1.2.840.10008.1.2.5");
    const QStringList files = test::writeSeries(series, path());
    SyntheticSeries second = series;
    second.size.z = 1;
    second.origin = series.position(3);
    second.fileName = [](int) { return QStringLiteral("second"); };
    second.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_SOPInstanceUID, "700");
        set.putAndInsertString(DCM_InstanceNumber, "99");
    };
    test::writeSeries(second, path());
    // RLE that does nothing for so long.
    constexpr int damaged = 150;
    constexpr int endOfSequence = 8;
    QFile fails(files[1]);
    QVERIFY(fails.open(QIODevice::ReadWrite));
    QVERIFY(fails.seek(fails.size() - endOfSequence - damaged));
    QCOMPARE(fails.write(QByteArray(damaged, '\x80')), qint64(damaged));
    fails.close();

    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    const core::LoadedVolume loaded = test::openVolume(path(), listing->candidates().front()->key);
    QCOMPARE(loaded.volume.geometry.size.z, 4);
    const std::vector<VolumeProblem>& problems = loaded.volume.problems;
    const QString failed = test::problemText(problems, VolumeProblem::Kind::DamagedSlice);
    QVERIFY2(failed.startsWith(QLatin1String("Slice 2 ")), qPrintable(failed));
    QVERIFY(test::hasProblem(problems, VolumeProblem::Kind::MissingSlices));
    const auto doubled =
        std::find_if(problems.begin(), problems.end(), [](const VolumeProblem& problem) {
            return problem.kind == VolumeProblem::Kind::DoubledSlices;
        });
    QVERIFY(doubled != problems.end());
    QVERIFY(doubled->caution);
    QVERIFY(doubled->slices == (std::vector<core::SliceSpan>{{.first = 3, .last = 3}}));
}

void StudyLoaderTest::badPathsAreClear()
{
    const auto codeOf = [](const QString& where) {
        const core::Result<core::LoadedVolume> loaded = core::loadVolume(where);
        return loaded ? core::ErrorCode::Internal : loaded.error().code;
    };
    QCOMPARE(codeOf(path(QStringLiteral("nowhere"))), core::ErrorCode::FileNotFound);
    QVERIFY(QDir().mkpath(path(QStringLiteral("empty"))));
    QCOMPARE(codeOf(path(QStringLiteral("empty"))), core::ErrorCode::FolderEmpty);
    QVERIFY(QDir().mkpath(path(QStringLiteral("texts"))));
    for (const char* name : {"texts/a.txt", "texts/b.txt"}) {
        QFile text(path(QString::fromLatin1(name)));
        QVERIFY(text.open(QIODevice::WriteOnly) && text.write("nothing of the kind, really") > 0);
    }
    QCOMPARE(codeOf(path(QStringLiteral("texts"))), core::ErrorCode::NoImages);
    QCOMPARE(codeOf(path(QStringLiteral("texts/a.txt"))), core::ErrorCode::UnsupportedFormat);
    QFile zero(path(QStringLiteral("zero.dcm")));
    QVERIFY(zero.open(QIODevice::WriteOnly));
    zero.close();
    QCOMPARE(codeOf(zero.fileName()), core::ErrorCode::FileTruncated);
    SyntheticSeries series;
    QFile header(test::writeSeries(series, path()).front());
    QVERIFY(header.resize(500));
    QCOMPARE(codeOf(header.fileName()), core::ErrorCode::FileTruncated);
}

void StudyLoaderTest::cancelStops()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    core::Progress* running = nullptr;
    int reports = 0;
    core::Progress progress([&](core::ProgressStep step, int, int) {
        ++reports;
        if (step == core::ProgressStep::ReadingSlices)
            running->cancel();
    });
    running = &progress;
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(path(), QString(), progress);
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, core::ErrorCode::Cancelled);
    QVERIFY(reports > series.size.z);
}

void StudyLoaderTest::nestedSequencesAreRefused()
{
    SyntheticSeries series;
    series.size.z = 1;
    QFile file(test::writeSeries(series, path()).front());
    QVERIFY(file.open(QIODevice::ReadWrite));
    QByteArray content = file.readAll();
    // ContentSequence (0040,A730) in itself, 20000 times, before the pixel data.
    const QByteArray item = QByteArray::fromHex("feff00e0ffffffff");
    QByteArray nested;
    for (int level = 0; level < 20000; ++level)
        nested += QByteArray::fromHex("400030a753510000ffffffff") + item;
    const qsizetype pixels = content.lastIndexOf(QByteArray::fromHex("e07f1000"));
    QVERIFY(pixels > 0);
    content.insert(pixels, nested);
    file.seek(0);
    file.write(content);
    file.close();
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(file.fileName());
    QVERIFY(!loaded);
    QVERIFY2(loaded.error().arguments.value(1).contains(QLatin1String("nested")),
        qPrintable(test::errorText(loaded.error())));
}

void StudyLoaderTest::multiFrameIsReported()
{
    SyntheticSeries series;
    series.size = {8, 8, 1};
    series.adjust = [](DcmDataset& set, int) { set.putAndInsertString(DCM_NumberOfFrames, "4"); };
    test::writeSeries(series, path());
    const core::Result<core::StudyListing> listing = core::scanStudies(path());
    QVERIFY(listing);
    QVERIFY(listing->candidates().empty());
    QCOMPARE(listing->foreign.front().kind, QStringLiteral("multi-frame image"));
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(path());
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, core::ErrorCode::NoImages);
    QVERIFY2(loaded.error().arguments.value(1).contains(QLatin1String("multi-frame")),
        qPrintable(test::errorText(loaded.error())));
}

void StudyLoaderTest::directoryFileStandsForItsFolder()
{
    SyntheticSeries series;
    test::writeSeries(series, path() + QStringLiteral("/IMAGES"));
    QFile directory(path() + QStringLiteral("/DICOMDIR"));
    QVERIFY(directory.open(QIODevice::WriteOnly));
    directory.close();
    QCOMPARE(test::worstError(test::openVolume(directory.fileName()), series), 0.0);
}

BURIN_TEST(StudyLoaderTest)

} // namespace studyLoaderTest

#include "StudyLoaderTest.moc"
