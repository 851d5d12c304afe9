// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/SegReader.h"
#include "core/export/common/ExportMask.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SmallSeries.h"
#include "tests/support/servers/Python.h"

#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace exportSegPeerTest {

/// A DICOM SEG of many frames against one that pydicom makes of the same mask: the same pixels, in
/// a file that is not larger. How long either took is printed; Burin's check included, pydicom has
/// none.
class ExportSegPeerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void thousandFrames();
};

void ExportSegPeerTest::thousandFrames()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.size = test::longRun() ? glm::ivec3(256, 256, 1000) : glm::ivec3(64, 48, 60);
    series.characterSet = "ISO_IR 192";
    series.patientName = "Thousand^Frames";
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    std::vector<std::uint8_t> labels;
    for (int z = 0; z < series.size.z; ++z)
        for (int y = 0; y < series.size.y; ++y)
            for (int x = 0; x < series.size.x; ++x)
                labels.push_back(
                    std::hypot(x - series.size.x / 2, y - series.size.y / 2) < 10 + z % 20 ? 1 : 0);
    const QString mask = folder.filePath(QStringLiteral("mask"));
    QFile raw(mask);
    QVERIFY(raw.open(QIODevice::WriteOnly)
        && raw.write(reinterpret_cast<const char*>(labels.data()), qint64(labels.size()))
            == qint64(labels.size()));
    raw.close();

    core::Segment segment;
    segment.label = 1;
    segment.name = QStringLiteral("Skull");
    segment.code = {.scheme = QStringLiteral("SCT"),
        .value = QStringLiteral("89546000"),
        .meaning = QStringLiteral("Skull")};
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    core::ExportRequest request{.file = folder.filePath(QStringLiteral("ours.dcm")),
        .segments = {segment},
        .planes = planes};
    QElapsedTimer timer;
    timer.start();
    const auto report = core::exportMask(volume, request, {});
    const qint64 ours = timer.elapsed();
    QVERIFY2(report, qPrintable(report ? QString() : report.error().arguments.join(u'|')));
    request.seg.deflated = true;
    request.file = folder.filePath(QStringLiteral("deflated.dcm"));
    QVERIFY(core::exportMask(volume, request, {}));
    const QString theirs = folder.filePath(QStringLiteral("theirs.dcm"));
    const auto peer = test::runScript(
        QStringLiteral("seg_write.py"), {folder.filePath(QStringLiteral("images")), mask, theirs});
    QVERIFY2(peer.exitCode == 0, qPrintable(peer.errors));

    const auto bytes = [&](const char* name) {
        return QFileInfo(folder.filePath(QLatin1String(name))).size();
    };
    qInfo("%d frames of %d x %d: Burin %lld ms, checked, %lld bytes (deflated %lld); pydicom %.0f "
          "ms, "
          "%lld bytes",
        series.size.z, series.size.x, series.size.y, static_cast<long long>(ours),
        static_cast<long long>(bytes("ours.dcm")), static_cast<long long>(bytes("deflated.dcm")),
        peer.output.trimmed().toDouble(), static_cast<long long>(bytes("theirs.dcm")));
    const auto mine = core::readSeg(folder.filePath(QStringLiteral("ours.dcm")));
    const auto other = core::readSeg(theirs);
    QVERIFY(mine && other);
    QCOMPARE(mine->frames.size(), std::size_t(series.size.z));
    QCOMPARE(other->frames.size(), mine->frames.size());
    QVERIFY(other->bits == mine->bits);
    // Each frame says more of itself: which image it was derived from, and how.
    QVERIFY(bytes("ours.dcm") < bytes("theirs.dcm") + qint64(256) * series.size.z);
    QVERIFY(bytes("deflated.dcm") < bytes("ours.dcm") / 4);
}

BURIN_TEST(ExportSegPeerTest)

} // namespace exportSegPeerTest

#include "ExportSegPeerTest.moc"
