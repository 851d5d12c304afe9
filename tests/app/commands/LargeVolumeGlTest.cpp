// SPDX-License-Identifier: Apache-2.0
#include "core/brick/BrickGrid.h"
#include "core/nifti/NiftiHeader.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/NrrdFiles.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStorageInfo>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace largeVolumeGlTest {

using core::VoxelBox;

namespace {

/// The most memory that `burin run` may take, textures included where the driver computes on the
/// processor: for each voxel 5.1 bytes of textures and cells, 3 of an export (labels, the label
/// map, what is read back to check it; or 1 of labels and 2 of codes), and the rest for what was
/// edited; and that much for everything else.
constexpr double budgetPerVoxel = 10.0;
constexpr double budgetBesides = 512.0 * 1024 * 1024;

struct Large {
    glm::ivec3 size{0};
    bool isBytes = false; ///< a NIfTI file of bytes; otherwise an NRRD file of 16 bits

    [[nodiscard]] qint64 voxels() const { return qint64(size.x) * size.y * size.z; }
    [[nodiscard]] double budget() const
    {
        return budgetPerVoxel * double(voxels()) + budgetBesides;
    }
    /// What is bright: it lies towards the far corner, where a number of a voxel is greatest.
    [[nodiscard]] VoxelBox box() const { return {size * 39 / 64, size * 63 / 64}; }
    [[nodiscard]] glm::ivec3 seed() const { return (box().minimum + box().maximum) / 2; }
    /// How far a voxel of the box can be from the seed along each axis, and how far it is at least.
    [[nodiscard]] glm::ivec3 farthest() const
    {
        return glm::max(seed() - box().minimum, box().maximum - 1 - seed());
    }
    [[nodiscard]] int nearest() const
    {
        const glm::ivec3 each = glm::min(seed() - box().minimum, box().maximum - 1 - seed());
        return std::min({each.x, each.y, each.z});
    }
    [[nodiscard]] qint64 boxVoxels() const
    {
        const glm::ivec3 extent = box().maximum - box().minimum;
        return qint64(extent.x) * extent.y * extent.z;
    }
    /// A drill into the near side of the box, across columns and slices: millimetres, and voxels.
    [[nodiscard]] int drillRadius() const
    {
        const glm::ivec3 extent = box().maximum - box().minimum;
        return std::min({20, extent.x / 6, extent.z / 6});
    }
    [[nodiscard]] int drillDepth() const { return 3 * drillRadius() / 2; }
};

/// What grows from one voxel in that many generations where nothing is in the way, if voxels that
/// share a face are neighbours.
qint64 octahedron(qint64 generations)
{
    return (2 * generations + 1) * (2 * generations * generations + 2 * generations + 3) / 3;
}

constexpr int dark = 20; ///< and up to 15 more, as in the box
constexpr int bright = 120;

template <class Value>
void fillSlice(std::vector<char>& bytes, const glm::ivec3& size, const VoxelBox& box, int z)
{
    bytes.resize(std::size_t(size.x) * std::size_t(size.y) * sizeof(Value));
    auto* to = reinterpret_cast<Value*>(bytes.data());
    for (int y = 0; y < size.y; ++y) {
        const bool crosses =
            z >= box.minimum.z && z < box.maximum.z && y >= box.minimum.y && y < box.maximum.y;
        for (int x = 0; x < size.x; ++x)
            *to++ = Value(dark + ((x + y + z) & 15));
        if (!crosses)
            continue;
        for (Value* in = to - size.x + box.minimum.x; in < to - size.x + box.maximum.x; ++in)
            *in = Value(*in + (bright - dark));
    }
}

/// Slice by slice: a test must not need the memory that it measures.
bool writeVolume(const QString& path, const Large& large)
{
    core::VolumeGeometry geometry;
    geometry.size = large.size;
    QByteArray header = test::nrrd::onGrid(geometry, "ushort", {});
    if (large.isBytes) {
        const core::NiftiHeader nifti =
            core::makeNiftiHeader(geometry, core::NiftiHeader::DataType::UInt8, {}, false);
        header = QByteArray(nifti.bytes.data(), qsizetype(nifti.bytes.size()));
    }
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(header) != header.size())
        return false;
    std::vector<char> slice;
    for (int z = 0; z < large.size.z; ++z) {
        if (large.isBytes)
            fillSlice<std::uint8_t>(slice, large.size, large.box(), z);
        else
            fillSlice<std::uint16_t>(slice, large.size, large.box(), z);
        if (file.write(slice.data(), qint64(slice.size())) != qint64(slice.size()))
            return false;
    }
    return file.flush();
}

QString key(const char* name)
{
    return QLatin1String(name);
}

QJsonArray vectorOf(const glm::ivec3& of)
{
    return {of.x, of.y, of.z};
}

/// One voxel is a millimetre, and the first one lies at the origin.
QJsonObject recipeFor(const Large& large, const QTemporaryDir& folder)
{
    const glm::ivec3 seed = large.seed();
    const auto grow = [](const QJsonValue& steps) {
        return QJsonObject{{key("edit"), key("grow")}, {key("lower"), bright - 20},
            {key("upper"), bright + 60}, {key("connectivity"), 6}, {key("steps"), steps}};
    };
    const QJsonObject view{{key("eyeLps"), vectorOf({seed.x, -200, seed.z})},
        {key("targetLps"), vectorOf({seed.x, 0, seed.z})}, {key("up"), vectorOf({0, 0, 1})},
        {key("heightMm"), 300}, {key("orthographic"), true}};
    const QJsonObject drill{{key("edit"), key("drill")}, {key("view"), view},
        {key("mask"),
            QJsonObject{{key("shape"), key("circle")}, {key("radiusMm"), large.drillRadius()}}},
        {key("depthMm"), large.drillDepth()},
        {key("surface"), QJsonObject{{key("threshold"), (dark + bright) / 2}}},
        {key("samples"), QJsonArray{QJsonValue(QJsonArray{0, 0, 1, 0})}}};
    const auto target = [&folder](const char* format, const char* file) {
        return QJsonObject{{key("format"), key(format)}, {key("file"), folder.filePath(key(file))}};
    };
    QJsonObject coverage = target("coverage", "cut.nii");
    coverage[key("layer")] = 1;
    return {{key("edits"),
                QJsonArray{QJsonObject{{key("edit"), key("addSegment")}, {key("name"), key("Box")},
                               {key("color"), key("#e8dcc0")}},
                    QJsonObject{{key("edit"), key("seed")}, {key("segment"), 1},
                        {key("pointsLps"), QJsonArray{QJsonValue(vectorOf(seed))}}},
                    grow(large.nearest()), drill, grow(key("toClosure"))}},
        // Numbers last: they read the study's values, which are kept for what follows.
        {key("export"),
            QJsonArray{target("nifti", "mask.nii"), coverage, target("csv", "mask.csv")}}};
}

/// A number of a file of /proc, in bytes; 0: it is not there.
qint64 bytesIn(const QString& path, const char* name)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    for (const QByteArray& line : file.readAll().split('\n')) {
        if (line.startsWith(name))
            return line.simplified().split(' ').value(1).toLongLong() * 1024;
    }
    return 0;
}

struct Watched {
    int status = -1; ///< −1: it crashed or did not end
    std::vector<QJsonObject> rows; ///< what it tells of edits
    std::vector<QJsonObject> exports;
    QString complaint;
    qint64 peakBytes = 0; ///< the most memory that it had, as last seen
    qint64 firstRowMs = 0; ///< from the start: the study is open
    qint64 lastRowMs = 0;
    qint64 endMs = 0;
};

/// Runs the program with more patience than test::burin() has, and watches its memory.
Watched runWatched(const QStringList& arguments)
{
    constexpr int everyMs = 50;
    constexpr qint64 patienceMs = 3'600'000;
    QProcess process;
    process.start(QStringLiteral(BURIN_PROGRAM), arguments);
    Watched watched;
    if (!process.waitForStarted())
        return watched;
    const QString status = QStringLiteral("/proc/%1/status").arg(process.processId());
    QElapsedTimer clock;
    clock.start();
    QByteArray output;
    const auto readOn = [&] {
        const QByteArray more = process.readAllStandardOutput();
        output += more;
        if (!more.contains("\"row\""))
            return;
        if (watched.firstRowMs == 0)
            watched.firstRowMs = clock.elapsed();
        watched.lastRowMs = clock.elapsed();
    };
    while (!process.waitForFinished(everyMs) && process.state() != QProcess::NotRunning) {
        watched.peakBytes = std::max(watched.peakBytes, bytesIn(status, "VmHWM:"));
        readOn();
        if (clock.hasExpired(patienceMs))
            return watched;
    }
    readOn();
    watched.endMs = clock.elapsed();
    if (process.exitStatus() == QProcess::NormalExit)
        watched.status = process.exitCode();
    watched.complaint = QString::fromUtf8(process.readAllStandardError());
    for (const QByteArray& line : output.split('\n')) {
        const QJsonObject told = QJsonDocument::fromJson(line).object();
        if (told.contains(key("row")))
            watched.rows.push_back(told);
        else if (told.contains(key("export")))
            watched.exports.push_back(told);
    }
    return watched;
}

qint64 changed(const QJsonObject& row)
{
    return qint64(row[key("voxelsChanged")].toDouble());
}

double seconds(const QJsonObject& row)
{
    return row[key("ms")].toDouble() * 1e-3;
}

/// Calls @p visit(z, slice) for every slice of an unpacked NIfTI file of bytes.
template <class Visit>
bool forEachSlice(const QString& path, const glm::ivec3& size, const Visit& visit)
{
    QFile file(path);
    const qint64 each = qint64(size.x) * size.y;
    if (!file.open(QIODevice::ReadOnly)
        || file.size() != core::NiftiHeader::voxelOffset + each * size.z
        || !file.seek(core::NiftiHeader::voxelOffset))
        return false;
    std::vector<std::uint8_t> slice(std::size_t(each), std::uint8_t(0));
    for (int z = 0; z < size.z; ++z) {
        if (file.read(reinterpret_cast<char*>(slice.data()), each) != each)
            return false;
        visit(z, std::as_const(slice));
    }
    return true;
}

/// How many voxels of a slice of the mask are not those of the box.
qint64 wrongInMask(const Large& large, int z, const std::vector<std::uint8_t>& slice)
{
    const VoxelBox box = large.box();
    qint64 wrong = 0;
    auto voxel = slice.begin();
    for (int y = 0; y < large.size.y; ++y) {
        const bool crosses =
            z >= box.minimum.z && z < box.maximum.z && y >= box.minimum.y && y < box.maximum.y;
        for (int x = 0; x < large.size.x; ++x, ++voxel) {
            const bool inside = crosses && x >= box.minimum.x && x < box.maximum.x;
            wrong += *voxel != (inside ? 1 : 0) ? 1 : 0;
        }
    }
    return wrong;
}

/// How many voxels of a slice of the coverage are carved beyond the drill's cylinder, or left
/// within it. A voxel and a half is left open, as where its side crosses voxels.
qint64 wrongInCut(const Large& large, int z, const std::vector<std::uint8_t>& slice)
{
    const double radius = large.drillRadius();
    const int dz = z - large.seed().z;
    qint64 wrong = 0;
    auto voxel = slice.begin();
    for (int y = 0; y < large.size.y; ++y) {
        const int depth = y - large.box().minimum.y;
        for (int x = 0; x < large.size.x; ++x, ++voxel) {
            const int dx = x - large.seed().x;
            const double away = std::sqrt(double(dx) * dx + double(dz) * dz);
            const bool within =
                away <= radius - 1.5 && depth >= 0 && depth < large.drillDepth() - 2;
            const bool beyond = away > radius + 1.5 || depth < -2 || depth > large.drillDepth() + 1;
            const bool carved = *voxel >= 128;
            wrong += (within && !carved) || (beyond && carved) ? 1 : 0;
        }
    }
    return wrong;
}

/// The entry of the only segment in a table of measurements.
QByteArray measured(const QString& path, const QByteArray& column)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QList<QByteArray> names = file.readLine().trimmed().split(',');
    const QList<QByteArray> values = file.readLine().trimmed().split(',');
    const qsizetype at = names.indexOf(column);
    return at < 0 ? QByteArray() : values.value(at);
}

QString megabytes(double bytes)
{
    return QString::number(bytes * 1e-6, 'f', 0);
}

} // namespace

/// Volumes that are large beside the machine's memory are opened, drawn (keyframes), grown, drilled
/// and exported by `burin run`, with the voxels that follow from their shape, and within a budget
/// of memory. Daily it runs on small ones. With BURIN_LONG=1 it prints what each size costs, and
/// takes up to 12 GB of memory and 5 GB of the disk.
class LargeVolumeGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void staysWithinItsBudget_data()
    {
        QTest::addColumn<Large>("large");
        const auto add = [](const glm::ivec3& size, bool isBytes) {
            QTest::addRow("%d x %d x %d, %s", size.x, size.y, size.z, isBytes ? "bytes" : "16 bits")
                << Large{size, isBytes};
        };
        if (!test::longRun()) {
            add({96, 80, 112}, false);
            add({80, 96, 130}, true);
            return;
        }
        for (const int side : {128, 256, 512})
            add(glm::ivec3(side), false);
        add({512, 512, 2000}, false);
        add({1024, 1024, 1024}, true);
        add({1024, 1024, 1024}, false);
    }
    void staysWithinItsBudget()
    {
        QFETCH(Large, large);
        const QTemporaryDir folder;
        QVERIFY(folder.isValid());
        // Beside the budget, what this machine needs for everything else.
        constexpr double margin = 1e9;
        const auto free = double(bytesIn(QStringLiteral("/proc/meminfo"), "MemAvailable:"));
        if (free < large.budget() + margin)
            QSKIP(qPrintable(QStringLiteral("%1 MB of memory are free, %2 are needed")
                                 .arg(megabytes(free), megabytes(large.budget() + margin))));
        const double written = double(large.voxels()) * (large.isBytes ? 3.0 : 4.0) + margin;
        const auto room = double(QStorageInfo(folder.path()).bytesAvailable());
        if (room < written)
            QSKIP(qPrintable(QStringLiteral("%1 MB of the disk are free, %2 are needed")
                                 .arg(megabytes(room), megabytes(written))));

        const QString study = folder.filePath(key(large.isBytes ? "study.nii" : "study.nrrd"));
        QVERIFY(writeVolume(study, large));
        QFile recipe(folder.filePath(key("recipe.json")));
        QVERIFY(recipe.open(QIODevice::WriteOnly));
        recipe.write(QJsonDocument(recipeFor(large, folder)).toJson());
        recipe.close();
        const Watched run = runWatched({key("run"), recipe.fileName(), key("--study"), study,
            key("--session"), folder.filePath(key("large.burin"))});
        QVERIFY2(run.status == 0, qPrintable(run.complaint));

        QCOMPARE(run.rows.size(), std::size_t(5));
        QCOMPARE(changed(run.rows[2]), octahedron(large.nearest()));
        QCOMPARE(changed(run.rows[4]), large.boxVoxels() - octahedron(large.nearest()));
        const glm::ivec3 farthest = large.farthest();
        const int steps = farthest.x + farthest.y + farthest.z - large.nearest();
        QVERIFY2(
            run.rows[4][key("name")].toString().contains(QStringLiteral(" %1 steps").arg(steps)),
            qPrintable(run.rows[4][key("name")].toString()));

        QCOMPARE(run.exports.size(), std::size_t(3));
        qint64 wrong = 0;
        QVERIFY(forEachSlice(folder.filePath(key("mask.nii")), large.size,
            [&](int z, const std::vector<std::uint8_t>& slice) {
                wrong += wrongInMask(large, z, slice);
            }));
        QCOMPARE(wrong, 0);
        qint64 touched = 0;
        QVERIFY(forEachSlice(folder.filePath(key("cut.nii")), large.size,
            [&](int z, const std::vector<std::uint8_t>& slice) {
                wrong += wrongInCut(large, z, slice);
                touched +=
                    qint64(slice.size()) - std::count(slice.begin(), slice.end(), std::uint8_t(0));
            }));
        QCOMPARE(wrong, 0);
        QCOMPARE(touched, changed(run.rows[3]));
        const QString table = folder.filePath(key("mask.csv"));
        QCOMPARE(measured(table, "voxels"), QByteArray::number(large.boxVoxels()));
        QCOMPARE(measured(table, "lastSlice"), QByteArray::number(large.box().maximum.z - 1));

        if (!test::longRun())
            return;
        qInfo("%d x %d x %d: open after %.1f s, first growth %.2f s, drill %.2f s, growth of %lld "
              "voxels %.2f s, exports %.1f s; at most %s MB, %.2f bytes for each voxel",
            large.size.x, large.size.y, large.size.z, double(run.firstRowMs) * 1e-3,
            seconds(run.rows[2]), seconds(run.rows[3]), changed(run.rows[4]), seconds(run.rows[4]),
            double(run.endMs - run.lastRowMs) * 1e-3, qPrintable(megabytes(double(run.peakBytes))),
            double(run.peakBytes) / double(large.voxels()));
        QVERIFY(run.peakBytes > 0);
        QVERIFY2(double(run.peakBytes) <= large.budget(),
            qPrintable(QStringLiteral("%1 MB, of %2")
                           .arg(megabytes(double(run.peakBytes)), megabytes(large.budget()))));
    }
};

BURIN_TEST(LargeVolumeGlTest)

} // namespace largeVolumeGlTest

#include "LargeVolumeGlTest.moc"
