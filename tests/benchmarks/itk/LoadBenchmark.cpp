// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/itk/LoadBenchmark.h"

#include "core/dicom/write/CtSeriesWriter.h"
#include "core/study/StudyLoader.h"
#include "tests/benchmarks/common/RowTimes.h"
#include "tests/benchmarks/common/TorsoVolume.h"
#include "tests/peers/readers/ItkSeries.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TraceEvents.h"
#include "ui/base/ErrorText.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fcntl.h>
#include <functional>
#include <map>
#include <memory>
#include <unistd.h>

namespace bench {

namespace {

constexpr int sliceCount = 450;
constexpr int repetitions = 5;
constexpr int coldRepetitions = 3;

using Values = std::vector<std::int16_t>;

core::Volume described(const core::Volume& torso)
{
    core::Volume volume = torso;
    volume.geometry.size.z = sliceCount;
    volume.identity.patientName = QStringLiteral("Torso^Made");
    volume.identity.patientId = QStringLiteral("T1");
    volume.identity.modality = QStringLiteral("CT");
    volume.identity.studyUid = QStringLiteral("2.25.1001");
    volume.identity.seriesUid = QStringLiteral("2.25.1002");
    volume.identity.frameOfReferenceUid = QStringLiteral("2.25.1003");
    return volume;
}

/// Hounsfield units of the torso's first slices, in the range that 12 bits hold.
Values torsoValues(const core::LoadedVolume& torso)
{
    Values values(std::size_t(512) * 512 * sliceCount);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] =
            std::int16_t(std::clamp(torso.volume.encoding.value(torso.codes[i]), -1024.0, 3071.0));
    return values;
}

/// The files of a folder in JPEG lossless, two at a time.
QString compress(const QString& from, const QString& to)
{
    const QStringList names = QDir(from).entryList(QDir::Files);
    std::vector<std::unique_ptr<QProcess>> running;
    const auto finish = [&running]() -> bool {
        const bool well = running.front()->waitForFinished(60'000)
            && running.front()->exitStatus() == QProcess::NormalExit
            && running.front()->exitCode() == 0;
        running.erase(running.begin());
        return well;
    };
    for (const QString& name : names) {
        if (running.size() == 2 && !finish())
            return QStringLiteral("dcmcjpeg failed");
        running.push_back(std::make_unique<QProcess>());
        running.back()->start(QStringLiteral("dcmcjpeg"),
            {QStringLiteral("+e1"), QDir(from).filePath(name), QDir(to).filePath(name)});
    }
    while (!running.empty()) {
        if (!finish())
            return QStringLiteral("dcmcjpeg failed");
    }
    return {};
}

/// Takes the files of a folder out of the system's cache.
void forget(const QString& folder)
{
    for (const QString& name : QDir(folder).entryList(QDir::Files)) {
        const int file = open(QFile::encodeName(QDir(folder).filePath(name)).constData(), O_RDONLY);
        if (file < 0)
            continue;
        (void)fdatasync(file);
        (void)posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
        (void)close(file);
    }
}

/// What somebody read, and how long it took; values in the order of slices along +z.
struct Read {
    QString why; ///< not empty: all else is void
    Values values;
    double milliseconds = 0.0;
    double firstSliceMilliseconds = 0.0; ///< until there was something to see; only Burin tells
};

Values valuesOf(const core::LoadedVolume& loaded)
{
    Values values(loaded.codes.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = std::int16_t(loaded.volume.encoding.value(loaded.codes[i]));
    return values;
}

Read readByBurin(const QString& folder)
{
    QElapsedTimer timer;
    timer.start();
    const auto elapsed = [&timer] { return double(timer.nsecsElapsed()) / 1e6; };
    const auto study = core::Study::scan(folder);
    if (!study)
        return {.why = ui::errorText(study.error()), .values = {}};
    double firstSlice = 0.0;
    const auto loaded =
        study->load({}, core::Progress(), [&](const auto&) { firstSlice = elapsed(); });
    const double spent = elapsed();
    if (!loaded)
        return {.why = ui::errorText(loaded.error()), .values = {}};
    if (firstSlice == 0.0)
        return {.why = QStringLiteral("no slice was told of before the volume"), .values = {}};
    return {.why = {},
        .values = valuesOf(*loaded),
        .milliseconds = spent,
        .firstSliceMilliseconds = firstSlice};
}

Read readByItk(const QString& folder)
{
    peer::ItkSeries series = peer::readItkSeries(folder.toStdString());
    if (!series.error.empty())
        return {.why = QString::fromStdString(series.error), .values = {}};
    return {.why = {}, .values = std::move(series.values), .milliseconds = series.milliseconds};
}

Read readByDcm2niix(const QString& folder)
{
    const QTemporaryDir out;
    QElapsedTimer timer;
    timer.start();
    QProcess process;
    process.setStandardOutputFile(QProcess::nullDevice());
    process.start(QStringLiteral("dcm2niix"),
        {QStringLiteral("-b"), QStringLiteral("n"), QStringLiteral("-z"), QStringLiteral("n"),
            QStringLiteral("-f"), QStringLiteral("made"), QStringLiteral("-o"), out.path(),
            folder});
    if (!process.waitForFinished(600'000) || process.exitCode() != 0)
        return {.why = QStringLiteral("dcm2niix failed"), .values = {}};
    const double spent = double(timer.nsecsElapsed()) / 1e6;
    const auto loaded = core::loadVolume(out.filePath(QStringLiteral("made.nii")));
    if (!loaded)
        return {.why = ui::errorText(loaded.error()), .values = {}};
    return {.why = {}, .values = valuesOf(*loaded), .milliseconds = spent};
}

/// dcm2niix stores rows upside down, as is usual in NIfTI.
Values rowsReversed(const Values& values)
{
    Values reversed(values.size());
    for (std::size_t row = 0; row < values.size() / 512; ++row) {
        const std::size_t other = row / 512 * 512 + 511 - row % 512;
        std::copy_n(values.begin() + std::ptrdiff_t(row * 512), 512,
            reversed.begin() + std::ptrdiff_t(other * 512));
    }
    return reversed;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

struct Reader {
    const char* name;
    Read (*read)(const QString& folder);
    bool upsideDown = false;
};

constexpr std::array<Reader, 3> readers{
    {{"burin", readByBurin}, {"ITK GDCM", readByItk}, {"dcm2niix", readByDcm2niix, true}}};

QString measureFolder(
    PeerReport& report, const QString& id, const QString& folder, const Values& expected)
{
    for (const bool cold : {false, true}) {
        std::map<std::string, std::vector<double>> times;
        std::vector<double> firstSlices;
        // The first warms the cache and proves that all read the same.
        for (int i = cold ? 1 : 0; i <= (cold ? coldRepetitions : repetitions); ++i) {
            for (const Reader& reader : readers) {
                if (cold)
                    forget(folder);
                const RowTimes::Clock::time_point begin = RowTimes::Clock::now();
                const Read read = reader.read(folder);
                if (!read.why.isEmpty())
                    return QStringLiteral("%1: %2").arg(QLatin1String(reader.name), read.why);
                if (i == 0
                    && (reader.upsideDown ? rowsReversed(read.values) : read.values) != expected)
                    return QStringLiteral("%1: %2 reads other values")
                        .arg(id, QLatin1String(reader.name));
                if (i > 0)
                    times[reader.name].push_back(read.milliseconds);
                if (i > 0 && !cold && reader.read == readByBurin)
                    RowTimes::took(
                        (id + QStringLiteral(".warm")).toStdString(), begin, read.milliseconds);
                if (i > 0 && read.firstSliceMilliseconds > 0.0)
                    firstSlices.push_back(read.firstSliceMilliseconds);
            }
        }
        const std::string name = (id + QLatin1String(cold ? ".cold" : ".warm")).toStdString();
        if (!cold)
            RowTimes::moves((id + QStringLiteral(".warm")).toStdString(),
                4.0 * double(expected.size()), "each value read and written, were it not coded");
        const double ours = median(times[readers[0].name]);
        for (std::size_t peer = 1; peer < readers.size(); ++peer)
            report.add({name, "Ms", ours, readers[peer].name, median(times[readers[peer].name])});
        report.add({name + ".firstSlice", "Ms", median(firstSlices), "the whole series", ours});
    }
    return {};
}

struct Opening {
    QString why; ///< there are no figures; empty: there are
    double longestMs = 0.0; ///< that the window stood still
    double refinedMs = 0.0; ///< until every view is refined
};

/// By the program's own trace: from where the study's reading begins to the last refined picture.
Opening openWindow(const QString& study)
{
    const QTemporaryDir home;
    const QString trace = home.filePath(QStringLiteral("trace.json"));
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"})
        environment.insert(QLatin1String(name), home.filePath(QLatin1String(name)));
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(BURIN_PROGRAM),
        {QStringLiteral("open"), study, QStringLiteral("--screenshot"),
            home.filePath(QStringLiteral("window.png")), QStringLiteral("--trace"), trace});
    if (!process.waitForFinished(600'000) || process.exitCode() != 0)
        return {.why = QString::fromUtf8(process.readAllStandardError())};
    const std::vector<test::TraceEvent> events = test::traceEvents(test::bytesOf(trace));
    qint64 begin = -1;
    qint64 end = -1;
    for (const test::TraceEvent& event : events) {
        const bool reads = event.category == QLatin1String("task")
            && event.name.contains(QLatin1String("StudyOpener"));
        if (reads && (begin < 0 || event.begin < begin))
            begin = event.begin;
        if (event.category == QLatin1String("frame")
            && event.name == QLatin1String("refined picture"))
            end = std::max(end, event.end);
    }
    if (begin < 0 || end < begin)
        return {.why = QStringLiteral("the trace tells of no study")};
    qint64 longest = 0;
    for (const test::TraceEvent& event : events) {
        if (event.category == QLatin1String("window") && event.begin >= begin && event.begin < end)
            longest = std::max(longest, event.end - event.begin);
    }
    return {.why = {}, .longestMs = double(longest) / 1e6, .refinedMs = double(end - begin) / 1e6};
}

QString measureWindow(PeerReport& report, const QString& study)
{
    std::fprintf(stderr, "loading: in the window\n");
    std::vector<double> longest;
    std::vector<double> refined;
    for (int round = 0; round < coldRepetitions; ++round) {
        const Opening opening = openWindow(study);
        if (!opening.why.isEmpty())
            return QStringLiteral("load.window: ") + opening.why;
        longest.push_back(opening.longestMs);
        refined.push_back(opening.refinedMs);
    }
    report.add(
        {"load.window.longestStall", "Ms", *std::max_element(longest.begin(), longest.end())});
    report.add({"load.window.refined", "Ms", median(refined)});
    return {};
}

} // namespace

QString measureLoading(PeerReport& report)
{
    std::fprintf(stderr, "loading: a series of %d slices\n", sliceCount);
    const QTemporaryDir folder;
    const QString native = folder.filePath(QStringLiteral("native"));
    const QString lossless = folder.filePath(QStringLiteral("lossless"));
    if (!QDir().mkpath(native) || !QDir().mkpath(lossless))
        return QStringLiteral("no place for files");
    Values expected;
    {
        const core::LoadedVolume torso = TorsoVolume::make();
        expected = torsoValues(torso);
        const core::Volume volume = described(torso.volume);
        const auto written = core::writeCtSeries(native,
            {.identity = volume.identity,
                .geometry = volume.geometry,
                .hounsfield = expected,
                .window = volume.defaultWindow,
                .bodyPart = QStringLiteral("ABDOMEN"),
                .manufacturer = QStringLiteral("Burin"),
                .comments = {},
                .instanceUid = [](int k) { return QStringLiteral("2.25.2%1").arg(k); }});
        if (!written)
            return ui::errorText(written.error());
    }
    if (QString why = measureFolder(report, QStringLiteral("load.native"), native, expected);
        !why.isEmpty())
        return why;
    if (QString why = measureWindow(report, native); !why.isEmpty())
        return why;
    std::fprintf(stderr, "loading: the same in JPEG lossless\n");
    if (QString why = compress(native, lossless); !why.isEmpty())
        return why;
    return measureFolder(report, QStringLiteral("load.lossless"), lossless, expected);
}

} // namespace bench
