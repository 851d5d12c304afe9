// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/FuzzTargets.h"
#include "tests/support/program/TestProgram.h"

#include <QDirIterator>
#include <QFile>
#include <QTest>

#include <algorithm>
#include <array>

namespace fuzzCorpusTest {

namespace {

struct Target {
    const char* folder;
    void (*run)(test::FuzzBytes);
};

constexpr std::array targets{Target{"dicom", test::fuzzDicom}, Target{"seg", test::fuzzSeg},
    Target{"rtstruct", test::fuzzRtStruct}, Target{"nifti", test::fuzzNifti},
    Target{"niftigz", test::fuzzPackedNifti}, Target{"nrrd", test::fuzzNrrd},
    Target{"metaimage", test::fuzzMetaImage}, Target{"nhdr", test::fuzzNrrdHeader},
    Target{"mhd", test::fuzzMetaHeader}, Target{"probability", test::fuzzProbability},
    Target{"images", test::fuzzImages}, Target{"mesh", test::fuzzMesh},
    Target{"session", test::fuzzSession}, Target{"delta", test::fuzzDelta},
    Target{"surfacestep", test::fuzzSurfaceStep}, Target{"recipe", test::fuzzRecipe},
    Target{"multipart", test::fuzzMultipart}, Target{"webanswer", test::fuzzWebAnswer},
    Target{"archive", test::fuzzArchive}, Target{"decoderreply", test::fuzzDecoderReply},
    Target{"decoderrequest", test::fuzzDecoderRequest}};

} // namespace

/// Every input that fuzzing found something with, once more, and what strangers try first:
/// tests/data/fuzz/TARGET/WHAT.
class FuzzCorpusTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void foundCasesAreSurvived_data();
    void foundCasesAreSurvived();
    void everyFolderIsATarget();
    void everyTargetHasCases();
};

void FuzzCorpusTest::foundCasesAreSurvived_data()
{
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("file");
    const QDir root(QStringLiteral(BURIN_TEST_DATA_DIR "/fuzz"));
    for (const QString& target : root.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        for (const QFileInfo& file : QDir(root.filePath(target)).entryInfoList(QDir::Files)) {
            const QString name = target + QLatin1Char('/') + file.fileName();
            QTest::newRow(qPrintable(name)) << target << file.filePath();
        }
    }
}

void FuzzCorpusTest::foundCasesAreSurvived()
{
    QFETCH(QString, target);
    QFETCH(QString, file);
    QFile input(file);
    QVERIFY(input.open(QIODevice::ReadOnly));
    const QByteArray bytes = input.readAll();
    for (const Target& known : targets) {
        if (target == QLatin1String(known.folder))
            known.run({reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                std::size_t(bytes.size())});
    }
}

void FuzzCorpusTest::everyFolderIsATarget()
{
    const QDir root(QStringLiteral(BURIN_TEST_DATA_DIR "/fuzz"));
    const QStringList folders = root.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    QVERIFY(!folders.isEmpty());
    for (const QString& folder : folders) {
        QVERIFY2(std::any_of(targets.begin(), targets.end(),
                     [&](const auto& target) { return folder == QLatin1String(target.folder); }),
            qPrintable(folder));
    }
}

void FuzzCorpusTest::everyTargetHasCases()
{
    const QDir root(QStringLiteral(BURIN_TEST_DATA_DIR "/fuzz"));
    for (const Target& target : targets) {
        const QDir cases(root.filePath(QLatin1String(target.folder)));
        QVERIFY2(!cases.entryList(QDir::Files).isEmpty(), target.folder);
    }
}

BURIN_TEST(FuzzCorpusTest)

} // namespace fuzzCorpusTest

#include "FuzzCorpusTest.moc"
