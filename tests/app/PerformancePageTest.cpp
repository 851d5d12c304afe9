// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "tests/support/servers/Python.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace performancePageTest {

/// packaging/performance.py makes a page of the manual of what the benchmarks have measured.
class PerformancePageTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] QString written(const char* name, const QByteArray& text) const
    {
        QFile file(m_folder.filePath(QLatin1String(name)));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write %s", name);
        return file.fileName();
    }
    [[nodiscard]] test::ScriptOutput page(
        const QByteArray& figures, const QStringList& more = {}) const
    {
        return test::runProgram(QStringLiteral("/usr/bin/python3"),
            QStringList{QStringLiteral(BURIN_SOURCE_DIR "/packaging/performance.py"),
                written("figures.json", figures),
                written("graphics.txt",
                    "GL_RENDERER  llvmpipe (LLVM 15)\nGL_VERSION   4.5 Mesa 22.3.6\n")}
                + more);
    }
    static void expectLines(const QByteArray& page, std::initializer_list<const char*> lines)
    {
        for (const char* line : lines)
            QVERIFY2(page.contains(line), (line + ("\n" + page)).constData());
    }

private Q_SLOTS:
    void goalsAreMetOrNot()
    {
        const test::ScriptOutput made = page(
            R"([{"id":"frame.mip","oursMs":100.0,"peer":"VTK GPU mapper","peerMs":270.0,"ratio":2.7},
             {"id":"frame.mip","oursMs":100.0,"peer":"VTK fixed-point mapper","peerMs":270.0,"ratio":2.7},
             {"id":"steer.slider","oursMs":99.5},
             {"id":"steer.words","oursBytes per 1000":17000.0},
             {"id":"history.drill.bytes","oursBytes":1234.0,"peer":"full copy","peerBytes":12340.0,"ratio":10.0}])");
        QVERIFY2(made.exitCode == 0, made.output.constData());
        QVERIFY(made.output.contains("- graphics: llvmpipe (LLVM 15), OpenGL 4.5 Mesa 22.3.6\n"));
        QVERIFY(made.output.contains("- machine: "));
        for (const char* line :
            {"| picture at full quality | `frame.mip` | 100 ms | VTK GPU mapper: "
             "270 ms | 2.70 | at least 6 times as fast | no |\n",
                "| picture at full quality | `frame.mip` | 100 ms | VTK fixed-point mapper: 270 ms "
                "| 2.70 | at least 2 times as fast | yes |\n",
                "| `steer.slider` | 99.5 ms |  |  | at most 100 ms | yes |\n",
                "| `steer.words` | 17000 bytes per 1000 |  |  |\n",
                "| `history.drill.bytes` | 1234 bytes | full copy: 12340 bytes | 10.00 |\n",
                "- oblique plane with contour: `plane\\.(linear|cubic)`, "
                "vtkImageReslice + vtkCutter\n"})
            QVERIFY2(made.output.contains(line), (line + ("\n" + made.output)).constData());
        // What is there is not said to be missing.
        QVERIFY(!made.output.contains("- an event of the interval slider"));
    }

    void missedRowsTellWhereTheirTimeGoes()
    {
        const QString profile = written("profile.json",
            R"({"triadBytesPerSecond":1.0e10,"copyBytesPerSecond":8.0e9,"rows":[
              {"id":"frame.mip","turns":4,"milliseconds":100.0,"bytes":3.0e8,"moved":"each voxel read",
               "passes":[{"kind":"gpu","name":"raycast.comp","milliseconds":60.0},
                         {"kind":"task","name":"reading","milliseconds":5.0},
                         {"kind":"gpu","name":"tiny","milliseconds":0.9}]},
              {"id":"frame.surface","turns":4,"milliseconds":5.0,"bytes":0,"moved":"","passes":[]}]})");
        const QString tried =
            written("tried.json", R"({"grow.*":["a queue"],"frame.mip":["from the top down"]})");
        const test::ScriptOutput made = page(
            R"([{"id":"frame.mip","oursMs":100.0,"peer":"VTK GPU mapper","peerMs":270.0,"ratio":2.7},
             {"id":"frame.surface","oursMs":5.0,"peer":"VTK GPU mapper","peerMs":270.0,"ratio":54.0},
             {"id":"grow.ball","oursMs":9.0,"peer":"ITK ConnectedThreshold","peerMs":9.0,"ratio":1.0},
             {"id":"grow.cube","oursMs":9.0,"peer":"ITK ConnectedThreshold","peerMs":9.0,"ratio":1.0}])",
            {QStringLiteral("--profile"), profile, QStringLiteral("--tried"), tried});
        QVERIFY2(made.exitCode == 0, made.output.constData());
        expectLines(made.output,
            {"Memory moved 10.0 GB a second",
                "### `frame.mip`\n\n100 ms (VTK GPU mapper: 270 ms, 2.70), goal: at least 6 times "
                "as fast.\n",
                "| kernel or draw `raycast.comp` | 60.0 | 60 % |\n",
                "| task beside it `reading` | 5.00 | 5 % |\n",
                "| other kernels and draws | 0.90 | 1 % |\n", "waits | 39.1 | 39 % |\n",
                "It moves about 300 MB (each voxel read): 3.00 GB a second, 30.0 % of what memory "
                "moves, so memory bounds it in part.\n",
                "- tried: from the top down\n", "- tried: a queue\n", "- tried: see `grow.ball`\n",
                "Not profiled.\n"});
        // For a row that meets its goal no reason is given.
        QVERIFY(!made.output.contains("### `frame.surface`"));
    }

    void aMinuteInTheWindowIsShown()
    {
        const QString pacing = written("pacing.json",
            R"({"figures":[{"id":"pacing.orbit","oursMs":40.0},{"id":"pacing.orbit.worst","oursMs":90.0},
                           {"id":"pacing.longestStall","oursMs":61.0}],
                "longest":{"ms":61.0,"phase":"drill","event":"ui::VolumeView, Paint","eventMs":44.0}})");
        const test::ScriptOutput made = page("[]", {QStringLiteral("--pacing"), pacing});
        QVERIFY2(made.exitCode == 0, made.output.constData());
        expectLines(made.output,
            {"| `pacing.orbit` | 40.0 ms |  |  | at most 66.67 ms | yes |\n",
                "| `pacing.longestStall` | 61.0 ms |  |  | at most 50 ms | no |\n",
                "| `pacing.orbit.worst` | 90.0 ms |  |  |\n",
                "Longest stall of the window: 61.0 ms, in the part *drill* (*ui::VolumeView, "
                "Paint*, "
                "44.0 ms).\n",
                "](frame-pacing.png)\n"});
        QVERIFY(!page("[]").output.contains("frame-pacing.png"));
    }

    void withoutFiguresAllIsMissing()
    {
        const test::ScriptOutput made = page("[]");
        QVERIFY2(made.exitCode == 0, made.output.constData());
        QVERIFY(made.output.contains("Not measured in this run:"));
        QVERIFY(!made.output.contains("## Other figures"));
        QVERIFY(!made.output.contains("| yes |"));
        QVERIFY(page("no figures").exitCode != 0);
    }
};

BURIN_TEST(PerformancePageTest)

} // namespace performancePageTest

#include "PerformancePageTest.moc"
