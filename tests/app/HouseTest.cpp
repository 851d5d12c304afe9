// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QRegularExpression>
#include <QTest>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace houseTest {

namespace {

/// What files of one room must not include (DESIGN §2).
struct Rule {
    QString room; ///< path prefix of the file, from the top of the tree
    std::function<bool(const QString& file, const QString& included)> forbids;
    QString reason;
};

bool inFolder(const QString& path, const QStringList& folders)
{
    for (const QString& folder : folders) {
        if (path.startsWith(folder + QLatin1Char('/')))
            return true;
    }
    return false;
}

bool ofQtModule(const QString& included, const QStringList& modules)
{
    static const QDir headers(QLibraryInfo::path(QLibraryInfo::HeadersPath));
    for (const QString& module : modules) {
        if (inFolder(included, {module}))
            return true;
        if (included.startsWith(QLatin1Char('Q'))
            && headers.exists(module + QLatin1Char('/') + included))
            return true;
    }
    return false;
}

bool isGl(const QString& included)
{
    static const QRegularExpression pattern(
        QStringLiteral("^(GL|GLES\\d?|EGL|KHR|epoxy)/|^QOpenGL(Extra)?Functions"));
    return pattern.match(included).hasMatch();
}

/// Who has a thread of its own, in which no event loop is needed (core/README.md says why there are
/// several). None is to be added without a reason.
bool mayOwnThread(const QString& file)
{
    static const QStringList folders{QStringLiteral("core/base")}; // the door itself
    static const QStringList files{
        QStringLiteral("core/sessionfile/SessionFile.h"), // the writer of a session
        // Parts of a session, whose results its poll() takes: differences, chunks, surfaces.
        QStringLiteral("core/session/state/CommitWorker.h"),
        QStringLiteral("core/session/state/ChunkWorker.h"),
        QStringLiteral("core/session/surface/SideThread.h"),
        QStringLiteral("core/session/surface/SideThread.cpp"),
        // Beside the engine's thread, which takes the answer between two pictures.
        QStringLiteral("gpu/kernels/shrink/CutPreviewer.h"),
        // They wait, for a signal, a line or a node, and compute nothing.
        QStringLiteral("app/end/CommandTermination.h"), QStringLiteral("core/pacs/WireWatch.h"),
        QStringLiteral("core/pacs/retrieve/MoveListener.h"),
        // One task beside calls of parallelFor, which parallelFor itself cannot be given.
        QStringLiteral("core/dicom/stack/StackLoader.cpp"),
        QStringLiteral("core/volume/encoding/VolumeEncoder.cpp")};
    return inFolder(file, folders) || files.contains(file);
}

const std::vector<Rule>& rules()
{
    using S = const QString&;
    const auto roomsAbove = [](QStringList rooms) {
        return [rooms = std::move(rooms)](S, S included) { return inFolder(included, rooms); };
    };
    const auto qtModules = [](QStringList modules) {
        return
            [modules = std::move(modules)](S, S included) { return ofQtModule(included, modules); };
    };
    const auto gl = [](S, S included) { return isGl(included); };
    const auto dcmtk = [](S file, S included) {
        return inFolder(included, {QStringLiteral("dcmtk")})
            && !(inFolder(file, {QStringLiteral("core/dicom"), QStringLiteral("core/pacs")})
                && file.endsWith(QLatin1String(".cpp")));
    };
    const auto network = [](S file, S included) {
        return ofQtModule(included, {QStringLiteral("QtNetwork")})
            && !(inFolder(file, {QStringLiteral("core/dicomweb")})
                && file.endsWith(QLatin1String(".cpp")));
    };
    // Who needs voxels asks the session, whose parts know how.
    const auto engine = [](S, S included) {
        return inFolder(included, {QStringLiteral("core/engine")})
            || included == QLatin1String("core/edits/engine/EngineEdits.h");
    };
    // By these a session's engine could be reached.
    const auto insideOfSessions = [](S file, S included) {
        return !inFolder(file, {QStringLiteral("core/session")})
            && (inFolder(included,
                    {QStringLiteral("core/session/state"),
                        QStringLiteral("core/session/operations")})
                || included == QLatin1String("core/session/questions/QuestionLine.h"));
    };
    const auto taskThread = [](S file, S included) {
        return included == QLatin1String("core/base/TaskThread.h") && !mayOwnThread(file);
    };
    const QString core = QStringLiteral("core"), gpu = QStringLiteral("gpu"),
                  ui = QStringLiteral("ui"), app = QStringLiteral("app");
    const QString gui = QStringLiteral("QtGui"), widgets = QStringLiteral("QtWidgets"),
                  openGl = QStringLiteral("QtOpenGL"),
                  openGlWidgets = QStringLiteral("QtOpenGLWidgets");
    static const std::vector<Rule> table{
        {core, roomsAbove({gpu, ui, app}), QStringLiteral("core knows no other room")},
        {core, qtModules({gui, widgets, openGl, openGlWidgets}),
            QStringLiteral("core knows no picture and no window")},
        {core, gl, QStringLiteral("GL belongs to gpu")},
        {gpu, roomsAbove({ui, app}), QStringLiteral("gpu knows core only")},
        {gpu, qtModules({gui, widgets, openGl, openGlWidgets}),
            QStringLiteral("gpu knows no window")},
        {ui, roomsAbove({app}), QStringLiteral("app composes, nobody includes it")},
        {ui, gl, QStringLiteral("GL belongs to gpu")},
        {core, taskThread, QStringLiteral("work beside others is for Background or ParallelFor")},
        {gpu, taskThread, QStringLiteral("work beside others is for Background or ParallelFor")},
        {ui, taskThread, QStringLiteral("work beside the window is told by core/base/Background")},
        {app, taskThread, QStringLiteral("work beside others is for Background or ParallelFor")},
        {app, gl, QStringLiteral("GL belongs to gpu")},
        {core, dcmtk, QStringLiteral("DCMTK stays inside core/dicom/*.cpp and core/pacs/*.cpp")},
        {gpu, dcmtk, QStringLiteral("DCMTK stays inside core/dicom/*.cpp and core/pacs/*.cpp")},
        {ui, dcmtk, QStringLiteral("DCMTK stays inside core/dicom/*.cpp and core/pacs/*.cpp")},
        {app, dcmtk, QStringLiteral("DCMTK stays inside core/dicom/*.cpp and core/pacs/*.cpp")},
        {core, network, QStringLiteral("the web is spoken in core/dicomweb/*.cpp")},
        {gpu, network, QStringLiteral("the web is spoken in core/dicomweb/*.cpp")},
        {ui, network, QStringLiteral("the web is spoken in core/dicomweb/*.cpp")},
        {app, network, QStringLiteral("the web is spoken in core/dicomweb/*.cpp")},
        {ui, engine, QStringLiteral("ui asks the session (core/session/README.md)")},
        {core, insideOfSessions, QStringLiteral("EditSession.h and its parts are the door")},
        {gpu, insideOfSessions, QStringLiteral("EditSession.h and its parts are the door")},
        {ui, insideOfSessions, QStringLiteral("EditSession.h and its parts are the door")},
        {app, insideOfSessions, QStringLiteral("EditSession.h and its parts are the door")},
        // The oracle is worth something only while it shares no kernel with what it judges.
        {QStringLiteral("tests/reference"), roomsAbove({gpu, ui, app}),
            QStringLiteral("the oracle knows core only")},
    };
    return table;
}

/// Where core words whole sentences: what describes an edit, wherever that is read. None is to be
/// added.
bool mayHoldSentences(const QString& file)
{
    static const QStringList folders{QStringLiteral("core/edits/schema")};
    static const QStringList files{QStringLiteral("core/recipe/RecipeStep.cpp"),
        QStringLiteral("core/brick/ThreadWithoutVoxels.cpp")}; // for who debugs it
    return inFolder(file, folders) || files.contains(file);
}

/// Where product files write, move or remove a file. Everything else hands its bytes to
/// core/base/files/StagedFile, which leaves no half of a file and touches none that a run reads.
/// None is to be added without a reason.
bool mayWriteFiles(const QString& file)
{
    static const QStringList folders{QStringLiteral("core/base/files")}; // the door itself
    static const QStringList files{
        // What they write lies in a staged place, which StagedFile made and moves.
        QStringLiteral("core/dicom/write/SaveDicom.cpp"),
        QStringLiteral("core/export/MeasurementsCsv.cpp"),
        QStringLiteral("core/export/WriteStatistics.cpp"),
        QStringLiteral("core/demo/DemoStudy.cpp"), QStringLiteral("app/steps/TracedRun.cpp"),
        QStringLiteral("ui/dialogs/export/Screenshot.cpp"),
        QStringLiteral("ui/report/WriteAudit.cpp"),
        // Sessions, which SQLite writes: new ones, those set aside, copies beside them.
        QStringLiteral("core/sessionfile/SessionPlaces.cpp"),
        QStringLiteral("core/sessionfile/database/SessionUse.cpp"),
        QStringLiteral("app/window/Application.cpp"),
        // What arrives or is unpacked, into a folder that this process made for it.
        QStringLiteral("core/archive/ArchiveReader.cpp"),
        QStringLiteral("core/dicomweb/WebIntake.cpp"),
        QStringLiteral("core/pacs/retrieve/DownloadFolder.cpp"),
        QStringLiteral("core/pacs/retrieve/ObjectIntake.cpp"),
        // A batch, in the hidden folder of its attempt and in its own records.
        QStringLiteral("app/batch/StudyAttempt.cpp"), QStringLiteral("app/batch/StudyResults.cpp"),
        QStringLiteral("app/end/EndNote.cpp")}; // why a program ended, for its next start
    return inFolder(file, folders) || files.contains(file);
}

/// Where a thread that must not look at voxels looks at some after all. None is to be added without
/// a reason, which is said there.
bool mayLookAtVoxels(const QString& file)
{
    static const QStringList folders{
        QStringLiteral("core/brick"), QStringLiteral("tests")}; // the door itself; the oracle
    static const QStringList files{QStringLiteral("core/session/RestoreSession.cpp"),
        QStringLiteral("core/session/questions/VoxelQuestions.cpp"),
        QStringLiteral("ui/tools/aim/SeenVoxels.cpp")};
    return inFolder(file, folders) || files.contains(file);
}

/// Where core and gpu word clauses that are no core::Clause. None is to be added.
bool mayHoldClauses(const QString& file)
{
    // What an edit's fields are, wherever that is read.
    static const QStringList folders{QStringLiteral("core/edits/fields"),
        QStringLiteral("core/edits/schema"),
        // Parts of a DICOM object, beside what DCMTK says of them.
        QStringLiteral("core/dicom/write")};
    // First decoders, whose words go through the pipe of their process.
    static const QStringList files{QStringLiteral("core/dicom/codecs/FrameCodec.cpp"),
        QStringLiteral("core/dicom/codecs/Jpeg2000.cpp"),
        QStringLiteral("core/dicom/codecs/JpegCheck.cpp"),
        QStringLiteral("core/fence/DecodeWorker.cpp"), QStringLiteral("core/images/ImageCodec.cpp"),
        QStringLiteral("core/images/PngDecoder.cpp"), QStringLiteral("core/images/TiffDecoder.cpp"),
        // Words of file formats, and of SQL.
        QStringLiteral("core/meshfile/MeshWriter.cpp"), QStringLiteral("core/nrrd/NrrdReader.cpp"),
        QStringLiteral("core/nrrd/NrrdWriter.cpp"),
        QStringLiteral("core/sessionfile/database/SessionSchema.cpp"),
        QStringLiteral("core/base/MemoryReserve.h"), // what an exception of the library says
        QStringLiteral("core/sessionfile/SessionSalvage.cpp"), // knows a clause by its form
        // A formula, for who measures; names of textures and programs; a shader that is missing.
        QStringLiteral("gpu/engine/MemoryFormula.cpp"),
        QStringLiteral("gpu/fields/VoxelFields.cpp"),
        QStringLiteral("gpu/kernels/shrink/ShrinkKernel.cpp"),
        QStringLiteral("gpu/shaders/ShaderLibrary.cpp"),
        QStringLiteral("core/recipe/RecipeStep.cpp"), // as the fields of edits
        QStringLiteral("core/sessionfile/database/SessionDatabase.cpp")}; // a message of SQLite
    return inFolder(file, folders) || files.contains(file);
}

const QRegularExpression& literals()
{
    static const QRegularExpression literal(
        QStringLiteral("\"(?:[^\"\\\\\n]|\\\\.)*\"(?:\\s*\"(?:[^\"\\\\\n]|\\\\.)*\")*"));
    return literal;
}

/// Literals that begin with a small letter and hold two blanks, wherever they are handed to, but
/// for those of a Clause, of assertions and of what the graphics driver is told.
QStringList clausesIn(QString code)
{
    static const QRegularExpression assertion(QStringLiteral("\\bstatic_assert\\([^;]*;"));
    static const QRegularExpression worded(
        QStringLiteral("(?:\\bsaying\\(|\\.label =|\\b(?:qFatal|bufferOf|words)\\()\\s*$"));
    static const QRegularExpression clause(QStringLiteral("^\"[a-z][^\"]* [^\"]* "));
    static const QRegularExpression seam(QStringLiteral("\"\\s*\""));
    code.remove(assertion);
    QStringList clauses;
    for (auto match = literals().globalMatch(code); match.hasNext();) {
        const QRegularExpressionMatch literal = match.next();
        const QString text = literal.captured().remove(seam);
        if (!clause.match(text).hasMatch())
            continue;
        if (!worded.match(code.left(literal.capturedStart()).right(80)).hasMatch())
            clauses += text;
    }
    return clauses;
}

/// Literals that begin as a sentence does and end with a full stop.
QStringList sentencesIn(const QString& code)
{
    static const QRegularExpression seam(QStringLiteral("\"\\s*\""));
    static const QRegularExpression sentence(
        QStringLiteral("^\"(?:[A-Z]|%\\d|').*[a-z]{2}.* .*\\.\\s*\"$"));
    QStringList sentences;
    for (auto match = literals().globalMatch(code); match.hasNext();) {
        const QString text = match.next().captured().remove(seam);
        if (sentence.match(text).hasMatch())
            sentences += text;
    }
    return sentences;
}

/// Where ui words texts that are not translated. None is to be added.
bool mayHoldTexts(const QString& file)
{
    // The report stays English, as DICOM does; names of fonts, styles and folders.
    static const QStringList files{QStringLiteral("ui/report/AuditHtml.cpp"),
        QStringLiteral("ui/report/AuditPages.cpp"), QStringLiteral("ui/report/AuditTexts.cpp"),
        QStringLiteral("ui/report/PaperText.cpp"), QStringLiteral("ui/base/Theme.cpp"),
        QStringLiteral("ui/dialogs/export/SuggestedTarget.cpp"),
        QStringLiteral("app/end/OrderlyEnd.cpp")}; // knows messages of Qt by their words
    return files.contains(file);
}

/// What a user reads of the literals that are made a QString as they stand: two words, or one with
/// a capital letter. Style sheets, HTML, keys and names of widgets are none.
QStringList textsIn(const QString& code)
{
    static const QRegularExpression begin(
        QStringLiteral("\\b(?:QStringLiteral|QLatin1String|fromUtf8|fromLatin1)\\(\\s*(?=\")"));
    static const QRegularExpression words(
        QStringLiteral("[A-Za-z]{2,}[,;:.]? +[a-zA-Z(%“]|^\"[A-Z][a-z]+(?: …|\\.|: .*)?\"$"));
    static const QRegularExpression markup(
        QStringLiteral("[{}<>]|^\"(?:color|background|padding|border)\\b[^ ]*: |^\"\\w+\\+|"
                       "^\"(?:Burin|Between|Mirror|Reshape)\"$"));
    static const QRegularExpression oneWord(QStringLiteral("^\"\\w+\"$"));
    static const QRegularExpression behindAName(QStringLiteral("\\+\\s*$"));
    static const QRegularExpression seam(QStringLiteral("\"\\s*\""));
    QStringList texts;
    for (auto match = begin.globalMatch(code); match.hasNext();) {
        const QRegularExpressionMatch here = match.next();
        const QString text = literals()
                                 .match(code, here.capturedEnd(), QRegularExpression::NormalMatch,
                                     QRegularExpression::AnchorAtOffsetMatchOption)
                                 .captured()
                                 .remove(seam);
        if (!words.match(text).hasMatch() || markup.match(text).hasMatch())
            continue;
        const bool isEndOfName = oneWord.match(text).hasMatch()
            && behindAName.match(code.left(here.capturedStart()).right(40)).hasMatch();
        if (!isEndOfName)
            texts += text;
    }
    return texts;
}

/// One sentence per broken rule. @p file is the path from the top of the tree.
QStringList brokenRules(const QString& file, const QString& text)
{
    static const QRegularExpression include(
        QStringLiteral("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]"),
        QRegularExpression::MultilineOption);
    // A loader may write the version line and comments may speak of layouts.
    static const QRegularExpression comment(QStringLiteral("//[^\n]*"));
    static const QRegularExpression glsl(
        QStringLiteral("layout *\\( *(local_size|binding|std430|location)|\\bgl_[A-Z]\\w+ID\\b"));
    QStringList broken;
    for (auto match = include.globalMatch(text); match.hasNext();) {
        const QString included = match.next().captured(1);
        for (const Rule& rule : rules()) {
            if (inFolder(file, {rule.room}) && rule.forbids(file, included))
                broken << QStringLiteral("%1 includes %2: %3").arg(file, included, rule.reason);
        }
    }
    if (!inFolder(file, {QStringLiteral("tests")})
        && glsl.match(QString(text).remove(comment)).hasMatch())
        broken << QStringLiteral("%1 holds GLSL: shaders live in files of their own").arg(file);
    // What is thrown on a thread ends the program, unless the thread is of one of these.
    static const QRegularExpression thread(
        QStringLiteral("std::j?thread\\s*[({]|std::j?thread\\s+\\w+\\s*[;({]|QThread::create|"
                       "QThreadPool|QtConcurrent|std::async\\b"));
    const bool startsThreads = inFolder(
        file, {QStringLiteral("core/base"), QStringLiteral("gpu/engine"), QStringLiteral("tests")});
    if (!startsThreads && thread.match(QString(text).remove(comment)).hasMatch())
        broken << QStringLiteral("%1 starts a thread: core/base/TaskThread and ParallelFor do, "
                                 "which catch what it throws")
                      .arg(file);
    // Nor handed on by somebody's header.
    static const QRegularExpression taskThread(QStringLiteral("\\bTaskThread\\b"));
    if (!inFolder(file, {QStringLiteral("tests")}) && !mayOwnThread(file)
        && taskThread.match(QString(text).remove(include).remove(comment)).hasMatch())
        broken << QStringLiteral("%1 has a thread of its own: Background and ParallelFor are for "
                                 "work beside others")
                      .arg(file);
    static const QRegularExpression writes(QStringLiteral(
        "(?<!buffer)(?:\\.|->)open\\(\\s*QIODevice::(?:WriteOnly|ReadWrite|Append)|\\bO_CREAT\\b|"
        "\\bofstream\\b|\\bQSaveFile\\b|\\bQTemporaryFile\\b|\\bfopen\\([^;]*\"[wa]|"
        "\\bQFile::(?:remove|rename|copy)\\(|\\bfilesystem::(?:remove|rename|copy)"));
    if (!inFolder(file, {QStringLiteral("tests")}) && !mayWriteFiles(file)
        && writes.match(QString(text).remove(comment)).hasMatch())
        broken << QStringLiteral("%1 writes or removes a file: core/base/files/StagedFile does")
                      .arg(file);
    static const QRegularExpression looks(QStringLiteral("\\bVoxelsAllowed\\s+\\w+\\s*;"));
    if (!mayLookAtVoxels(file) && looks.match(QString(text).remove(comment)).hasMatch())
        broken << QStringLiteral("%1 looks at voxels on a thread that must not: a worker does")
                      .arg(file);
    // Who is told may be coming apart, too, and a part that was destroyed before is asked.
    static const QRegularExpression destructor(
        QStringLiteral("::~\\w+\\(\\)[^{};]*(\\{(?:[^{}]++|(?1))*+\\})"));
    for (auto match = destructor.globalMatch(QString(text).remove(comment));
         !inFolder(file, {QStringLiteral("tests")}) && match.hasNext();) {
        if (match.next().captured(1).contains(QLatin1String("Q_EMIT")))
            broken << QStringLiteral("%1 emits a signal while it is destroyed").arg(file);
    }
    static const QRegularExpression spinBox(
        QStringLiteral("\\b(?:new|public)\\s+Q(?:Double)?SpinBox\\b"));
    if (inFolder(file, {QStringLiteral("ui"), QStringLiteral("app")})
        && file != QLatin1String("ui/widgets/fields/NumberField.h")
        && spinBox.match(QString(text).remove(comment)).hasMatch())
        broken << QStringLiteral("%1 has a field that writes no true minus sign: "
                                 "ui/widgets/fields/NumberField does")
                      .arg(file);
    static const QRegularExpression testClass(
        QStringLiteral("^BURIN_(?:WINDOW_|PLAIN_)?TEST(?:_RUN)?\\((\\w)(\\w*)"),
        QRegularExpression::MultilineOption);
    QStringList own; // of the classes in it; one gives its name
    for (auto match = testClass.globalMatch(text); match.hasNext();) {
        const auto found = match.next();
        own += found.captured(1).toLower() + found.captured(2);
    }
    const bool stands = std::any_of(own.begin(), own.end(), [&text](const QString& name) {
        return text.contains(QStringLiteral("\nnamespace %1 {\n").arg(name));
    });
    if (!own.isEmpty() && !stands)
        broken << QStringLiteral("%1 is compiled with other tests: what it names belongs into a "
                                 "namespace %2")
                      .arg(file, own.last());
    if (inFolder(file, {QStringLiteral("core"), QStringLiteral("gpu")})) {
        static const QRegularExpression translation(
            QStringLiteral("\\btr\\(\\s*\"|::translate\\(\\s*\"|\\bQ_DECLARE_TR_FUNCTIONS\\b"));
        const QString code = QString(text).remove(include).remove(comment);
        if (translation.match(code).hasMatch())
            broken << QStringLiteral("%1 translates: ui does").arg(file);
        for (const QString& sentence : mayHoldSentences(file) ? QStringList() : sentencesIn(code))
            broken << QStringLiteral("%1 says %2: a code with arguments is worded in ui/texts")
                          .arg(file, sentence);
        for (const QString& clause : mayHoldClauses(file) ? QStringList() : clausesIn(code))
            broken << QStringLiteral("%1 says %2: a reason is a core::Clause").arg(file, clause);
    }
    const bool isWindow = inFolder(
        file, {QStringLiteral("ui"), QStringLiteral("app/window"), QStringLiteral("app/end")});
    if (isWindow && !mayHoldTexts(file)) {
        for (const QString& said : textsIn(QString(text).remove(include).remove(comment)))
            broken << QStringLiteral("%1 says %2: what a user reads goes through tr()")
                          .arg(file, said);
    }
    return broken;
}

/// Which folders each folder includes, and by which file.
using Arrows = std::map<QString, std::map<QString, QString>>;

/// A way along the arrows that comes back to where it began: "a → b (by b/B.h) → a (by …)"; empty
/// if there is none.
QString circleIn(const Arrows& arrows)
{
    enum class State { Under, Done };
    std::map<QString, State> states;
    QStringList way;
    const std::function<QString(const QString&)> follow = [&](const QString& folder) -> QString {
        states[folder] = State::Under;
        way.append(folder);
        const auto known = arrows.find(folder);
        for (const auto& [next, file] :
            known == arrows.end() ? std::map<QString, QString>() : known->second) {
            const auto state = states.find(next);
            if (state != states.end() && state->second == State::Done)
                continue;
            if (state != states.end()) {
                QString text = next;
                for (qsizetype i = way.indexOf(next); i < way.size(); ++i) {
                    const QString& to = i + 1 < way.size() ? way[i + 1] : next;
                    text += QStringLiteral(" → %1 (by %2)").arg(to, arrows.at(way[i]).at(to));
                }
                return text;
            }
            if (const QString circle = follow(next); !circle.isEmpty())
                return circle;
        }
        states[folder] = State::Done;
        way.removeLast();
        return {};
    };
    for (const auto& [folder, to] : arrows) {
        if (states.count(folder) == 0) {
            if (const QString circle = follow(folder); !circle.isEmpty())
                return circle;
        }
    }
    return {};
}

QString folderOf(const QString& path)
{
    return path.left(path.lastIndexOf(QLatin1Char('/')));
}

/// Every file of a room: sources and shaders, by its path from the top of the tree.
QStringList filesOf(const QString& room)
{
    const QDir top(QStringLiteral(BURIN_SOURCE_DIR));
    QStringList files;
    QDirIterator walk(top.filePath(room),
        {QStringLiteral("*.h"), QStringLiteral("*.cpp"), QStringLiteral("*.glsl"),
            QStringLiteral("*.comp"), QStringLiteral("*.vert"), QStringLiteral("*.frag")},
        QDir::Files, QDirIterator::Subdirectories);
    while (walk.hasNext())
        files.append(top.relativeFilePath(walk.next()));
    files.sort();
    return files;
}

QString contents(const QString& path)
{
    QFile file(QDir(QStringLiteral(BURIN_SOURCE_DIR)).filePath(path));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

bool isSource(const QString& file)
{
    return file.endsWith(QLatin1String(".h")) || file.endsWith(QLatin1String(".cpp"));
}

/// By what C++ includes, or by what shaders do: a kernel's shaders lie beside it, so that both
/// together may form a circle. Shaders name their files from the room on.
Arrows arrowsIn(const QString& room, bool ofShaders)
{
    static const QRegularExpression include(
        QStringLiteral("^#include \"([^\"]+)\""), QRegularExpression::MultilineOption);
    Arrows arrows;
    const QStringList files = filesOf(room); // what is generated is none
    for (const QString& file : files) {
        if (isSource(file) == ofShaders)
            continue;
        const QString text = contents(file);
        for (auto match = include.globalMatch(text); match.hasNext();) {
            const QString name = match.next().captured(1);
            const QString included = ofShaders ? room + QLatin1Char('/') + name : name;
            if (files.contains(included) && folderOf(included) != folderOf(file))
                arrows[folderOf(file)].emplace(folderOf(included), file);
        }
    }
    return arrows;
}

/// In which folders a test belongs instead of its own, by the files of its room: FooTest, FooGlTest
/// and FooUiTest lie where Foo lies. Empty: it may stay. A test that is named after none of these
/// files is about several of them, or about what a room below holds.
QStringList foldersMeant(const QString& test, const QStringList& files)
{
    static const QRegularExpression name(QStringLiteral("/((\\w+?)(?:Gl|Ui)?)Test\\.cpp$"));
    const QRegularExpressionMatch match = name.match(test);
    QStringList meant;
    for (const QString& file : match.hasMatch() ? files : QStringList()) {
        const QString of = QFileInfo(file).completeBaseName();
        if (isSource(file) && (of == match.captured(1) || of == match.captured(2)))
            meant += QStringLiteral("tests/") + folderOf(file);
    }
    meant.removeDuplicates();
    return meant.contains(folderOf(test)) ? QStringList() : meant;
}

} // namespace

/// The rooms know only what DESIGN §2 lets them know.
class HouseTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void ruleBites_data();
    void ruleBites();
    void ownFilesKeepTheRules();
    void circlesAreFound();
    void foldersFormNoCircle_data();
    void foldersFormNoCircle();
    void misplacedTestsAreFound();
    void testsMirrorTheProgram_data();
    void testsMirrorTheProgram();
    void foldersAreSmallAndNamed_data();
    void foldersAreSmallAndNamed();
    void sourcesHoldOneIdea();
};

void HouseTest::ruleBites_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("allowed");
    const auto row = [](const char* file, const char* text, bool allowed) {
        QTest::addRow("%s: %s", file, text)
            << QString::fromUtf8(file) << QString::fromUtf8(text) << allowed;
    };
    row("core/a/A.cpp", "#include \"gpu/A.h\"", false);
    row("core/a/A.cpp", "#include \"ui/A.h\"", false);
    row("core/a/A.h", "#include \"app/A.h\"", false);
    row("core/a/A.h", "#include <QImage>", false);
    row("core/a/A.h", "#include <QtGui/qcolor.h>", false);
    row("core/a/A.h", "#include <QWidget>", false);
    row("core/a/A.h", "# include <epoxy/gl.h>", false);
    row("core/a/A.h", "#include <QString>\n#include <QSqlQuery>\n#include \"core/b/B.h\"", true);
    row("core/a/A.cpp", "#include <dcmtk/dcmdata/dctk.h>", false);
    row("core/dicom/A.h", "#include <dcmtk/dcmdata/dctk.h>", false);
    row("core/dicom/A.cpp", "#include <dcmtk/dcmdata/dctk.h>", true);
    row("core/pacs/A.h", "#include <dcmtk/dcmnet/dimse.h>", false);
    row("core/pacs/A.cpp", "#include <dcmtk/dcmnet/dimse.h>", true);
    row("core/pacs/A.cpp", "#include <QNetworkReply>", false);
    row("core/dicomweb/A.h", "#include <QNetworkReply>", false);
    row("core/dicomweb/A.cpp", "#include <QNetworkReply>\n#include <QSslKey>", true);
    row("ui/A.cpp", "#include <QtNetwork/QNetworkReply>", false);
    row("gpu/A.h", "#include \"ui/A.h\"", false);
    row("gpu/A.h", "#include <QOpenGLContext>", false);
    row("gpu/A.h", "#include <QApplication>", false);
    row("gpu/A.cpp", "#include <epoxy/egl.h>\n#include \"core/a/A.h\"\n#include <QFile>", true);
    row("gpu/A.cpp", "auto text = \"layout(local_size_x = 64) in;\";", false);
    row("gpu/A.h", "/// layout(binding = 0) in the shader", true);
    row("ui/A.h", "#include \"app/A.h\"", false);
    row("ui/A.cpp", "#include <GL/gl.h>", false);
    row("ui/A.cpp", "#include <QOpenGLFunctions_4_5_Core>", false);
    row("ui/A.cpp", "#include \"gpu/A.h\"\n#include <QOpenGLContext>\n#include <QPainter>", true);
    row("ui/A.h", "#include \"core/engine/EngineCommands.h\"", false);
    row("ui/A.cpp", "#include \"core/edits/engine/EngineEdits.h\"", false);
    row("ui/A.cpp", "#include \"core/session/state/SessionState.h\"", false);
    row("ui/A.cpp",
        "#include \"core/session/questions/VoxelQuestions.h\"\n"
        "#include \"core/edits/kinds/sculpt/ToolMasks.h\"",
        true);
    row("app/A.cpp", "#include \"core/session/operations/OperationQueue.h\"", false);
    row("core/a/A.cpp", "#include \"core/session/questions/QuestionLine.h\"", false);
    row("core/session/A.cpp", "#include \"core/session/operations/OperationQueue.h\"", true);
    row("app/A.cpp", "#include <epoxy/gl.h>", false);
    row("app/A.cpp", "#include \"ui/A.h\"\n#include \"gpu/A.h\"\n#include \"core/A.h\"", true);
    row("tests/core/ATest.cpp", "\nclass ATest {\n};\n\nBURIN_TEST(ATest)\n", false);
    row("tests/ui/AUiTest.cpp", "\nnamespace aUiTest {\n\nBURIN_WINDOW_TEST(AUiTest)\n", true);
    row("tests/reference/A.cpp", "#include \"gpu/A.h\"", false);
    row("ui/A.h", "#include \"core/base/TaskThread.h\"", false);
    row("core/a/A.h", "#include \"core/base/TaskThread.h\"", false);
    row("gpu/A.h", "#include \"core/base/TaskThread.h\"", false);
    row("app/A.h", "#include \"core/base/TaskThread.h\"", false);
    row("core/pacs/WireWatch.h", "#include \"core/base/TaskThread.h\"", true);
    row("core/a/A.h", "class TaskThread;\n\n    std::unique_ptr<TaskThread> m_thread;", false);
    row("core/a/A.h", "/// As TaskThread does.\n    Background m_background;", true);
    row("core/pacs/WireWatch.h", "    TaskThread m_thread;", true);
    row("ui/A.h", "#include \"core/base/Background.h\"", true);
    row("ui/A.cpp", "m_thread.reset(QThread::create([] {}));", false);
    row("core/a/A.h", "    std::thread m_thread;", false);
    row("core/a/A.cpp", "auto a = std::thread([] {});", false);
    row("core/a/A.cpp", "auto a = std::async(std::launch::async, [] {});", false);
    row("core/a/A.cpp", "auto a = std::async(policy, [] {});", false);
    row("core/a/A.cpp", "// std::thread thread(work);\nstd::thread::hardware_concurrency();", true);
    row("core/base/A.cpp", "std::thread thread(work);", true);
    row("core/a/A.cpp", "notes += QStringLiteral(\"The mask is empty.\");", false);
    row("core/a/A.cpp", "text = QStringLiteral(\"%1 slices \"\n    \"are missing.\").arg(1);",
        false);
    row("core/a/A.cpp", "// \"The mask is empty.\"\n// \"no pixel belongs to a segment\"", true);
    row("core/a/A.cpp", "return damaged(\"no pixel belongs to a segment\");", false);
    row("core/a/A.cpp", "const char* why() { return \"no pixel \"\n    \"is set\"; }", false);
    row("core/a/A.cpp", "static_assert(is<X>(), \"an edit X needs a check\");", true);
    row("core/a/A.cpp", "reason = QStringLiteral(\"no pixel belongs to a segment\");", false);
    row("core/a/A.cpp", "reason = QStringLiteral(\n    \"piece %1 \"\n    \"is no piece\").arg(1);",
        false);
    row("core/a/A.cpp", "reason = Clause::saying(\"no pixel belongs to a segment\");", true);
    row("core/a/A.cpp", "name = QStringLiteral(\"left lung\");", true);
    row("core/edits/fields/A.cpp", "type = QStringLiteral(\"whole number or text\");", true);
    row("gpu/A.cpp", "reason = QStringLiteral(\"no pixel belongs to a segment\");", false);
    row("gpu/A.cpp", "return refusal(\"transaction\", \"an edit is open\");", false);
    row("gpu/A.cpp", "refusal(\"edit\", core::Clause::saying(\"an edit is open\"));", true);
    row("gpu/A.cpp", "m_list = Buffer({.label = \"bricks in reach\"});", true);
    row("core/export/A.cpp", "report += QStringLiteral(\"The slices are tilted.\");", false);
    row("core/edits/schema/A.h", "about = \"Carves along the view.\";", true);
    row("ui/texts/A.cpp", "return Texts::tr(\"The mask is empty.\");", true);
    row("ui/a/A.cpp", "label->setText(QStringLiteral(\"No study is open\"));", false);
    row("ui/a/A.cpp", "new QPushButton(QStringLiteral(\"Send\"));", false);
    row("app/window/A.cpp", "say(QStringLiteral(\"%1 is \"\n    \"not there.\").arg(name));",
        false);
    row("ui/a/A.cpp", "label->setText(tr(\"No study is open\"));", true);
    row("ui/a/A.cpp", "setObjectName(QStringLiteral(\"exportAll\"));", true);
    row("ui/a/A.cpp", "setObjectName(name + QStringLiteral(\"Progress\"));", true);
    row("ui/a/A.cpp", "setStyleSheet(QStringLiteral(\"color: %1\").arg(name));", true);
    row("ui/a/A.cpp", "keys = {QKeySequence(QStringLiteral(\"Shift+J\"))};", true);
    row("ui/a/A.cpp", "return core::Clause::saying(\"no study is open\");", true);
    row("app/commands/A.cpp", "print(QStringLiteral(\"no study is open\"));", true);
    row("core/a/A.cpp", "return tr(\"empty\");", false);
    row("gpu/A.cpp", "return QCoreApplication::translate(\"gpu\", \"empty\");", false);
    row("core/a/A.cpp", "moved = glm::translate(moved, by);", true);
    row("core/a/A.cpp", "if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate))", false);
    row("ui/A.cpp", "QFile::remove(path);", false);
    row("app/A.cpp", "std::ofstream out(path);", false);
    row("ui/A.cpp", "buffer.open(QIODevice::WriteOnly);", true);
    row("core/a/A.cpp", "QDataStream stream(&bytes, QIODevice::WriteOnly);", true);
    row("core/a/A.cpp", "file.open(QIODevice::ReadOnly);", true);
    row("core/base/files/A.cpp", "QFile::remove(path);", true);
    row("core/a/A.cpp", "const VoxelsAllowed folds; // still on this thread", false);
    row("core/edits/kinds/imports/ImportMask.cpp", "const VoxelsAllowed here;", false);
    row("ui/A.cpp", "const core::VoxelsAllowed few;", false);
    row("core/session/RestoreSession.cpp", "const VoxelsAllowed opens;", true);
    row("ui/A.cpp", "    , m_radius(new QDoubleSpinBox(this))", false);
    row("ui/A.cpp", "m_days = new QSpinBox(this);", false);
    row("ui/A.cpp", "class LengthField : public QDoubleSpinBox {", false);
    row("ui/A.cpp", "auto* box = findChild<QDoubleSpinBox*>();\n// new QSpinBox", true);
    row("ui/widgets/fields/NumberField.h", "class NumberField : public QDoubleSpinBox {", true);
    row("ui/A.cpp", "A::~A()\n{\n    if (m_b) {\n        m_b = {};\n    }\n    Q_EMIT ended();\n}",
        false);
    row("ui/A.cpp", "A::~A()\n{\n    stop();\n}\n\nvoid A::end()\n{\n    Q_EMIT ended();\n}", true);
}

void HouseTest::ruleBites()
{
    QFETCH(QString, file);
    QFETCH(QString, text);
    QFETCH(bool, allowed);
    const QStringList broken = brokenRules(file, text);
    QVERIFY2(broken.isEmpty() == allowed, qPrintable(broken.join(QLatin1Char('\n'))));
}

void HouseTest::ownFilesKeepTheRules()
{
    const QDir top(QStringLiteral(BURIN_SOURCE_DIR));
    QStringList broken;
    int files = 0;
    for (const char* room : {"core", "gpu", "ui", "app", "tests"}) {
        QDirIterator walk(top.filePath(QLatin1String(room)),
            {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
            QDirIterator::Subdirectories);
        while (walk.hasNext()) {
            QFile file(walk.next());
            QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
            broken += brokenRules(
                top.relativeFilePath(file.fileName()), QString::fromUtf8(file.readAll()));
            ++files;
        }
    }
    QVERIFY2(files > 20, "the walk found next to nothing: is BURIN_SOURCE_DIR right?");
    QVERIFY2(broken.isEmpty(), qPrintable(broken.join(QLatin1Char('\n'))));
}

void HouseTest::circlesAreFound()
{
    const QString a = QStringLiteral("a"), b = QStringLiteral("b"), c = QStringLiteral("c"),
                  file = QStringLiteral("x.h");
    QVERIFY(circleIn({}).isEmpty());
    QVERIFY(circleIn({{a, {{b, file}, {c, file}}}, {b, {{c, file}}}}).isEmpty());
    QCOMPARE(circleIn({{a, {{b, file}}}, {b, {{c, file}}}, {c, {{b, file}}}}),
        QStringLiteral("b → c (by x.h) → b (by x.h)"));
}

void HouseTest::foldersFormNoCircle_data()
{
    QTest::addColumn<QString>("room");
    QTest::addColumn<bool>("ofShaders");
    for (const char* room : {"core", "gpu", "ui", "app", "tests"})
        QTest::newRow(room) << QString::fromLatin1(room) << false;
    QTest::newRow("gpu, shaders") << QStringLiteral("gpu") << true;
}

void HouseTest::foldersFormNoCircle()
{
    QFETCH(QString, room);
    QFETCH(bool, ofShaders);
    const Arrows arrows = arrowsIn(room, ofShaders);
    QVERIFY(!arrows.empty());
    const QString circle = circleIn(arrows);
    QVERIFY2(circle.isEmpty(), qPrintable(circle));
}

void HouseTest::misplacedTestsAreFound()
{
    const QStringList files{QStringLiteral("core/a/A.cpp"), QStringLiteral("core/a/A.h"),
        QStringLiteral("core/b/B.h"), QStringLiteral("core/b/c/B.h"),
        QStringLiteral("core/b/light.glsl")};
    const auto meant = [&files](const char* test) {
        return foldersMeant(QString::fromLatin1(test), files).join(QLatin1Char(' '));
    };
    const QString a = QStringLiteral("tests/core/a"),
                  either = QStringLiteral("tests/core/b tests/core/b/c"), stays;
    QCOMPARE(meant("tests/core/b/ATest.cpp"), a);
    QCOMPARE(meant("tests/core/a/b/AGlTest.cpp"), a);
    QCOMPARE(meant("tests/core/AUiTest.cpp"), a);
    QCOMPARE(meant("tests/core/a/BTest.cpp"), either);
    QCOMPARE(meant("tests/core/a/ATest.cpp"), stays);
    QCOMPARE(meant("tests/core/a/AUiTest.cpp"), stays);
    QCOMPARE(meant("tests/core/b/c/BTest.cpp"), stays);
    QCOMPARE(meant("tests/core/b/ManyTest.cpp"), stays);
    QCOMPARE(meant("tests/core/a/lightTest.cpp"), stays);
    QCOMPARE(meant("tests/core/b/A.cpp"), stays);
}

void HouseTest::testsMirrorTheProgram_data()
{
    QTest::addColumn<QString>("room");
    for (const char* room : {"core", "gpu", "ui", "app"})
        QTest::newRow(room) << QString::fromLatin1(room);
}

void HouseTest::testsMirrorTheProgram()
{
    QFETCH(QString, room);
    // What commands do without a context; LostContextUiTest tells of the window's LostContext.
    const QStringList elsewhere{QStringLiteral("tests/app/commands/LostContextGlTest.cpp")};
    const QStringList files = filesOf(room);
    const QStringList tests = filesOf(QStringLiteral("tests/") + room);
    QVERIFY(!tests.empty());
    QStringList wrong;
    for (const QString& test : tests) {
        const QStringList meant = foldersMeant(test, files);
        if (!meant.empty() && !elsewhere.contains(test))
            wrong +=
                QStringLiteral("%1 belongs into %2").arg(test, meant.join(QStringLiteral(" or ")));
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

void HouseTest::foldersAreSmallAndNamed_data()
{
    QTest::addColumn<QString>("room");
    for (const char* room : {"core", "gpu", "ui", "app", "tests"})
        QTest::newRow(room) << QString::fromLatin1(room);
}

/// A folder of more files holds two ideas; what belongs there says the README of its room. Folders
/// of tests are called as those that they test, and tests/data holds no source.
void HouseTest::foldersAreSmallAndNamed()
{
    QFETCH(QString, room);
    constexpr int most = 28;
    std::map<QString, int> folders;
    for (const QString& file : filesOf(room))
        ++folders[folderOf(file)];
    const QString readme = contents(room + QStringLiteral("/README.md"));
    QStringList wrong;
    for (const auto& [folder, files] : folders) {
        if (files > most)
            wrong += QStringLiteral("%1 has %2 files").arg(folder).arg(files);
        const bool isNamed = folder == room || room == QLatin1String("tests")
            || readme.contains(QStringLiteral("`%1`").arg(folder.mid(room.size() + 1)));
        if (!isNamed)
            wrong += QStringLiteral("%1/README.md does not name %2").arg(room, folder);
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

/// A longer source holds two ideas.
void HouseTest::sourcesHoldOneIdea()
{
    constexpr qsizetype most = 500;
    QStringList wrong;
    for (const char* room : {"core", "gpu", "ui", "app"}) {
        for (const QString& file : filesOf(QLatin1String(room))) {
            const qsizetype lines = contents(file).count(QLatin1Char('\n'));
            if (lines > most)
                wrong += QStringLiteral("%1 has %2 lines").arg(file).arg(lines);
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

BURIN_TEST(HouseTest)

} // namespace houseTest

#include "HouseTest.moc"
