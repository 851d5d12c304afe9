// SPDX-License-Identifier: Apache-2.0
#include "app/CommandLine.h"

#include "app/Version.h"
#include "app/commands/CompareCommand.h"
#include "app/commands/DemoCommand.h"
#include "app/commands/EchoCommand.h"
#include "app/commands/EditsCommand.h"
#include "app/commands/FindCommand.h"
#include "app/commands/GetCommand.h"
#include "app/commands/HistoryCommand.h"
#include "app/commands/InfoCommand.h"
#include "app/commands/MeshCommand.h"
#include "app/commands/ReplayCommand.h"
#include "app/commands/RunCommand.h"
#include "app/commands/SendCommand.h"
#include "app/steps/Arguments.h"
#include "app/window/DisplayNeeded.h"
#include "app/window/GuardedApplication.h"
#include "app/window/OpenCommand.h"
#include "core/base/Guarded.h"
#include "core/base/files/PrivateFolder.h"

#include <QApplication>
#include <QFileInfo>
#include <QSettings>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

namespace app {

namespace {

std::span<const Command> commands()
{
    static const std::vector<Command> table{
        {"compare",
            "MASK REFERENCE --study PATH [--series UID] [--repair REPAIRS] [--segment NAME]"
            " [--reference NAME] [--json]",
            "how far a mask is from the one that is held for the truth: relative volume error,"
            " Dice, distances of the surfaces in mm; masks of any format, on the study's grid;"
            " with --json a line for each pair of segments",
            false, runCompare},
        {"demo", "DIR", "writes the demonstration study: a CT of a head, made by formulas", false,
            runDemo},
        {"echo", "SOURCE [--own-title TITLE] [--login-file FILE] [--timeout SECONDS] [--json]",
            "whether a PACS answers; SOURCE is AETITLE@host:port (DICOM), https://host/dicom-web"
            " (DICOMweb) or the name of one in the settings, for this and find, get, send, which"
            " all take --own-title (BURIN), --login-file (user:password or Bearer TOKEN; or in"
            " BURIN_LOGIN), --timeout (30), and for TLS --tls-authority FILE [--tls-certificate"
            " FILE --tls-key FILE], all PEM",
            false, runEcho},
        {"edits", "[--json]", "what a recipe can hold: every edit with its fields", false,
            runEdits},
        {"find",
            "SOURCE [--patient-name NAME] [--patient-id ID] [--date FROM-TO] [--modality MODALITY]"
            " [--accession NUMBER] [--description TEXT] [--most NUMBER] [--json] | SOURCE --study "
            "UID",
            "the studies at a source, or the series of one; * and ? stand for letters, dates"
            " are YYYYMMDD",
            false, runFind},
        {"get", "SOURCE --study UID [--series UID] --to FOLDER [--move PORT] [--json]",
            "downloads a study or series into a new folder, which is there only when it is whole;"
            " a download that broke off goes on; --move: the node brings them to that port"
            " (C-MOVE) instead of handing them over (C-GET)",
            false, runGet},
        {"history",
            "FILE.burin [--json | --as-recipe | --report OUT.html|OUT.pdf [--force]"
            " | --deidentified OUT.burin [--dates remove|keep|DAYS] [--force]]",
            "what was done in a session, branches included; as a recipe for burin run; as an audit"
            " report; as a session without the patient, for others",
            false, runHistory, "--report"},
        {"info",
            "PATH [--series UID] [--repair REPAIRS] [--spacing COLUMNS,ROWS,SLICES] [--json]"
            " | --gl",
            "what a file or folder holds: studies, volumes, what is wrong with them and which"
            " repairs there are; with --repair how they would open",
            false, runInfo},
        {"mesh",
            "MASK --study PATH --out FILE [--series UID] [--repair REPAIRS] [--segment NAME]"
            " [--vertices NUMBER] [--space lps|ras] [--json] [--force]",
            "the surface that refinement begins with, of each segment of a mask, as PLY, STL, OBJ"
            " or glTF (.glb), and how many of the mask's voxels it encloses; as many vertices as"
            " that takes, unless a number is asked for",
            false, runMesh},
        {"open",
            "[PATH [--series UID] [--repair REPAIRS] [--spacing COLUMNS,ROWS,SLICES] | FILE.burin "
            "[--study PATH] | --demo]"
            " [--screenshot FILE.png]"
            " [--size WxH]",
            "the workstation's window with a study, or with a session that goes on; --screenshot"
            " saves it, fully refined, as PNG or (.dcm) as Secondary Capture of the study, and "
            "exits",
            true, runOpen},
        {"replay",
            "FILE.burin --verify [--to ROW] [--export FILE [--format FORMAT] [--layer NUMBER]"
            " [--fill VALUE] [--deidentify] [--deflated] [--force]] [--study PATH] [--series UID]",
            "carries out a session's history again, from nothing, and compares every hash;"
            " --export writes the masks of that state, or with --format coverage --layer NUMBER "
            "what"
            " a sculpt layer carves (.nii.gz), or with --format carved-volume the study without "
            "what"
            " is carved (.nii.gz, or a new folder for a DICOM series; --fill: the value there,"
            " without it the least); --deidentify takes the patient out, --deflated makes a DICOM"
            " SEG smaller",
            false, runReplay},
        {"run",
            "RECIPE.json --study PATH [--series UID] [--repair REPAIRS]"
            " [--spacing COLUMNS,ROWS,SLICES] --session FILE.burin [--force | --append] "
            "[--with-images] [--apply-elsewhere] [--author NAME]",
            "carries out a recipe without a window (burin edits: what it can hold); --with-images"
            " puts the study's images, and with them who the patient is, into the session; --force"
            " replaces a session, which stays until the new one is whole;"
            " --repair, here and in info and open: what is done to the series on loading it, of"
            " tilt, spacing=even, gap=fill, gap=split:NUMBER, duplicates=first, duplicates=last,"
            " with commas between; none: nothing; --spacing: how many mm the voxels of PNG and TIFF"
            " pictures are apart",
            false, runRecipe},
        {"send", "SOURCE PATH... [--json]", "stores DICOM files, or those of folders, at a source",
            false, runSend},
    };
    return table;
}

void printHelp(FILE* out)
{
    std::fprintf(out,
        "burin %s — segmentation workstation (research use; not a medical device)\n\n",
        BURIN_VERSION);
    for (const Command& command : commands())
        std::fprintf(
            out, "  burin %s %s\n      %s\n", command.name, command.usage, command.summary);
}

/// They name the studies that were open last. Qt makes the file for everybody to read.
void keepSettingsPrivate()
{
    const QString file = QSettings().fileName();
    if (core::makePrivateFolder(QFileInfo(file).absolutePath()))
        core::makePrivateFile(file);
}

} // namespace

int runCommandLine(int argc, char** argv)
{
    const char* verb = argc > 1 ? argv[1] : "--help";
    for (const Command& command : commands()) {
        if (std::strcmp(verb, command.name) != 0)
            continue;
        std::unique_ptr<QCoreApplication> application;
        const auto isFontsFor = [&command](const char* word) {
            return command.fontsFor && std::strcmp(word, command.fontsFor) == 0;
        };
        const bool needsFonts = std::any_of(argv + 1, argv + argc, isFontsFor);
        if (needsFonts)
            qputenv("QT_QPA_PLATFORM", "offscreen");
        int status = 0;
        const core::Result<void> ran = core::guarded([&] {
            if (command.needsWindow) {
                const DisplayNeeded display;
                application = std::make_unique<GuardedApplication>(argc, argv);
            } else if (needsFonts) {
                application = std::make_unique<QGuiApplication>(argc, argv);
            } else {
                application = std::make_unique<QCoreApplication>(argc, argv);
            }
            QCoreApplication::setApplicationName(QStringLiteral("burin"));
            QCoreApplication::setOrganizationName(QStringLiteral("burin"));
            QCoreApplication::setApplicationVersion(QStringLiteral(BURIN_VERSION));
            if (command.needsWindow)
                keepSettingsPrivate();
            status = command.run(application->arguments().mid(2));
        });
        return ran ? status : tellFailure(ran.error());
    }
    if (std::strcmp(verb, "--version") == 0) {
        std::printf("burin %s\n", BURIN_VERSION);
        return 0;
    }
    const bool askedForHelp = std::strcmp(verb, "--help") == 0 || std::strcmp(verb, "help") == 0;
    if (!askedForHelp)
        std::fprintf(stderr, "burin: unknown command '%s'\n\n", verb);
    printHelp(askedForHelp ? stdout : stderr);
    return askedForHelp ? 0 : 2;
}

} // namespace app
