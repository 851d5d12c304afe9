// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/DicomElement.h"
#include "core/dicom/codecs/FrameCodec.h"
#include "core/fence/FencedDecoder.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/Sanitizer.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/defective/HostileDicom.h"
#include "ui/texts/ProblemTexts.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <cstdlib>
#include <cstring>

namespace fencedFramesTest {

namespace {

constexpr const char* weakOption = "--weak-decoder";
constexpr const char* jpegLossless = "1.2.840.10008.1.2.4.70";

/// A decoder that certain bytes behind an image hurt.
QString decodeWeakly(std::span<const std::uint8_t> parameters, std::span<const std::uint8_t> bytes,
    std::span<std::uint8_t> cells)
{
    const std::string_view end(reinterpret_cast<const char*>(bytes.data()) + bytes.size() - 4, 4);
    if (end == "STOP")
        std::abort();
    volatile bool hangs = end == "HANG";
    while (hangs) { }
    std::vector<std::vector<char>> all;
    while (end == "FILL")
        all.emplace_back(std::size_t(16) << 20, 'x');
    if (end == "LIES")
        std::fill(cells.begin(), cells.end(), std::uint8_t(0xff));
    return end == "LIES" ? QString() : core::decodeHere(parameters, bytes, cells);
}

core::WorkerProgram weakDecoder()
{
    return {.path = QStringLiteral("/proc/self/exe"),
        .arguments = {QStringLiteral("FencedFramesTest"), QString::fromLatin1(weakOption)}};
}

/// Puts four bytes behind the JPEG image of a file, into its fragment.
void append(const QString& path, const char* mark)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadWrite))
        qFatal("cannot open %s", qPrintable(path));
    QByteArray bytes = file.readAll();
    const qsizetype at = bytes.lastIndexOf(QByteArray("\xff\xd8\xff", 3));
    const core::DicomBytes view(
        reinterpret_cast<const std::uint8_t*>(bytes.constData()), std::size_t(bytes.size()));
    const std::uint32_t length = core::readUint32(view, std::size_t(at) - 4, false);
    bytes.replace(at - 4, 4, test::words({length + 4}));
    bytes.insert(at + qsizetype(length), mark, 4);
    file.seek(0);
    file.write(bytes);
}

} // namespace

/// What a series becomes when the decoder fails on some of its slices.
class FencedFramesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void failingSlicesAreLeftOutAndNamed();
    void oneFailingSliceIsOneSentence();
    void nothingLeftIsAnError();
    void withoutDecodersThereIsAReason();
    void valuesOfALyingDecoderStayStoredValues();
    void insideAndOutsideGiveTheSame();

private:
    QStringList write(const QTemporaryDir& folder, int slices = 20)
    {
        test::SyntheticSeries series;
        series.size.z = slices;
        series.transferSyntaxUid = QString::fromLatin1(jpegLossless);
        return test::writeSeries(series, folder.path());
    }
    static QString name(const QString& path) { return QFileInfo(path).fileName(); }
};

void FencedFramesTest::init()
{
    core::FencedDecoder::instance().setProgram(weakDecoder());
    core::FencedDecoder::instance().setPatience(std::chrono::milliseconds(3000));
}

void FencedFramesTest::failingSlicesAreLeftOutAndNamed()
{
    if (test::underSanitizer)
        QSKIP("A sanitizer ends a decoder that asks for more memory than it may have.");
    const QTemporaryDir folder;
    const QStringList files = write(folder);
    append(files[3], "STOP");
    append(files[9], "HANG");
    append(files[16], "FILL");
    const auto loaded = core::loadVolume(folder.path());
    QVERIFY(loaded);
    QCOMPARE(loaded->volume.sources.size(), std::size_t(17));
    QVERIFY(loaded->volume.needsCaution());
    QStringList texts;
    for (const core::VolumeProblem& problem : loaded->volume.problems) {
        if (problem.kind == core::VolumeProblem::Kind::DamagedSlice)
            texts += ui::problemText(problem.said);
    }
    QCOMPARE(texts.join(QLatin1Char('|')),
        QStringLiteral("Slice 4 (%1) could not be decoded: the decoder stopped; slice 10 (%2) "
                       "could not be decoded: the decoder took too long and was stopped; slice 17 "
                       "(%3) could not be decoded: decoding it takes more memory than such an "
                       "image may. They were left out.")
            .arg(name(files[3]), name(files[9]), name(files[16])));
}

void FencedFramesTest::oneFailingSliceIsOneSentence()
{
    const QTemporaryDir folder;
    const QStringList files = write(folder);
    append(files[16], "STOP");
    const auto loaded = core::loadVolume(folder.path());
    QVERIFY(loaded);
    QCOMPARE(core::storedText(loaded->volume.problems.back().said),
        QStringLiteral("Slice 17 (%1) could not be decoded: the decoder stopped. It was left out.")
            .arg(name(files[16])));
}

void FencedFramesTest::nothingLeftIsAnError()
{
    const QTemporaryDir folder;
    const QStringList files = write(folder, 1);
    append(files[0], "STOP");
    const auto loaded = core::loadVolume(folder.path());
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, core::ErrorCode::FileUnreadable);
    QCOMPARE(
        loaded.error().arguments, (QStringList{files[0], QStringLiteral("the decoder stopped")}));
}

void FencedFramesTest::withoutDecodersThereIsAReason()
{
    core::FencedDecoder::instance().setProgram({});
    const QTemporaryDir folder;
    const QStringList files = write(folder, 4);
    const auto loaded = core::loadVolume(folder.path());
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().arguments.value(1),
        QStringLiteral("the decoder cannot be started: nothing says which program it is"));
}

void FencedFramesTest::valuesOfALyingDecoderStayStoredValues()
{
    const QTemporaryDir folder;
    const QStringList files = write(folder);
    append(files[5], "LIES");
    const auto loaded = core::loadVolume(folder.path());
    QVERIFY(loaded);
    QCOMPARE(loaded->volume.sources.size(), std::size_t(20));
    // Twelve bits are stored; whatever else a cell holds is no part of a value.
    QCOMPARE(loaded->volume.maximum, 4095.0 - 1024.0);
}

void FencedFramesTest::insideAndOutsideGiveTheSame()
{
    const QTemporaryDir folder;
    write(folder);
    const auto outside = core::loadVolume(folder.path());
    core::FencedDecoder::instance().decodeInside(core::decodeHere);
    const auto inside = core::loadVolume(folder.path());
    QVERIFY(outside && inside);
    QCOMPARE(outside->volume.voxelsSha256, inside->volume.voxelsSha256);
    QVERIFY(outside->codes == inside->codes);
}

namespace {

int runFencedFrames(int argc, char** argv)
{
    if (argc == 2 && std::strcmp(argv[1], weakOption) == 0)
        return core::runDecodeWorker(core::readyCodecs, decodeWeakly);
    return test::runTest<FencedFramesTest, QCoreApplication>(argc, argv);
}

} // namespace

BURIN_TEST_RUN(FencedFramesTest, runFencedFrames)

} // namespace fencedFramesTest

#include "FencedFramesTest.moc"
