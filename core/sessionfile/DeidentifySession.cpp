// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/DeidentifySession.h"

#include "core/base/files/StagedError.h"
#include "core/base/files/StagedFile.h"
#include "core/edits/EditNames.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionPlaces.h"
#include "core/sessionfile/SessionSalvage.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <iterator>

namespace core {

namespace {

bool namesPatient(const QString& text, const QStringList& words)
{
    return std::any_of(
        words.begin(), words.end(), [&text](const QString& word) { return holdsWord(text, word); });
}

template <class Use> void useTexts(RowTitle& title, const Use& use);

/// An overload for each kind of argument: one that is added does not compile until it is known
/// whether it can hold a text, with which a name could pass.
template <class Use> struct UseTextsOfArgument {
    const Use& use;

    void operator()(QString& text) const { use(text); }
    void operator()(std::vector<RowTitle>& titles) const
    {
        for (RowTitle& each : titles)
            useTexts(each, use);
    }
    void operator()(const TitleCount&) const { }
    void operator()(const TitleNumber&) const { }
    void operator()(const TitleDecimal&) const { }
    void operator()(const TitleDigits&) const { }
};

/// Each text that a title holds, its own or of titles inside of it.
template <class Use> void useTexts(RowTitle& title, const Use& use)
{
    for (TitleArgument& argument : title.arguments)
        std::visit(UseTextsOfArgument<Use>{use}, argument);
    for (RowTitle& each : title.then)
        useTexts(each, use);
}

/// Names and titles of rows also hold the program's own words and units. Short words may be among
/// these (Hu and HU) and are looked for only in what people wrote, which the edits hold.
bool namesPatient(HistoryRow row, const QStringList& words)
{
    QStringList longWords;
    std::copy_if(words.begin(), words.end(), std::back_inserter(longWords), isSoughtWithinWords);
    bool names = namesPatient(row.name, longWords);
    if (row.title)
        useTexts(*row.title, [&](const QString& text) { names |= namesPatient(text, longWords); });
    const QStringList written = textsIn(row.edit);
    return names || std::any_of(written.begin(), written.end(), [&words](const QString& text) {
        return namesPatient(text, words);
    });
}

/// A name of a file that is not kept, or of a row that had it.
struct Renaming {
    QString from;
    QString to;
};

void renameIn(QString& text, const std::vector<Renaming>& renamings)
{
    for (const Renaming& renaming : renamings)
        text.replace(renaming.from, renaming.to);
}

/// Puts other texts into a row's name and its title.
template <class Use> void useTexts(HistoryRow& row, const Use& use)
{
    use(row.name);
    if (row.title)
        useTexts(*row.title, use);
    if (row.title && canonicalName(*row.title) != row.name)
        row.title.reset();
}

/// What rows quote of a row: its name without what it changed.
QString quoted(const HistoryRow& row)
{
    const QString name = row.title ? canonicalName(headlineOf(*row.title))
                                   : row.name.left(row.name.lastIndexOf(QLatin1String(", ")));
    return name.isEmpty() ? row.name : name;
}

/// Of a mask that was imported only the suffix of its file stays: file and folder may be named
/// after the patient. Later rows that quote such a row follow.
/// @param quotes of the rows before; one more, if this is such a row
HistoryRow neutral(HistoryRow row, const Deidentifier& by, std::vector<Renaming>& quotes)
{
    useTexts(row, [&quotes](QString& text) { renameIn(text, quotes); });
    changeFilesNamed(row.edit, [&](QString& file) {
        const QFileInfo named(file);
        if (named.fileName().isEmpty())
            return;
        file = QStringLiteral("mask.") + named.completeSuffix();
        const QString before = quoted(row);
        useTexts(row, [&](QString& text) { text.replace(named.fileName(), file); });
        if (!before.isEmpty())
            quotes.push_back({.from = before, .to = quoted(row)});
    });
    row.origin.author.clear();
    switch (by.options().dates) {
    case DeidentifyOptions::Dates::Remove:
        row.origin = {};
        break;
    case DeidentifyOptions::Dates::Shift:
        row.origin.at = row.origin.at.addDays(by.options().shiftDays);
        break;
    case DeidentifyOptions::Dates::Keep:
        break;
    }
    return row;
}

Result<void> copySteps(SessionFile& from, const SessionContents& contents, SessionFile& to,
    const Deidentifier& by, const QString& file)
{
    std::vector<Renaming> quotes;
    for (const HistoryRow& row : contents.rows) {
        const HistoryRow copied = neutral(row, by, quotes);
        if (namesPatient(copied, by.words()))
            return failure(ErrorCode::UnsupportedFormat, file,
                Clause::saying("step %1 holds a word of the patient's name or numbers, and no step "
                               "can be rewritten",
                    row.id));
        to.addRow(copied);
        if (row.stateHash.isEmpty())
            continue;
        const Result<BrickDelta> delta = from.readDelta(row.id);
        if (!delta)
            return tl::unexpected(delta.error());
        to.completeRow(row.id, row.stateHash, *delta);
    }
    // Rows were added in their order; redo goes where it went.
    for (const std::pair<RowId, RowId>& step : contents.visited)
        to.setPosition(step.second);
    to.setPosition(contents.position);
    to.setHiddenSegments(contents.hiddenSegments);
    return to.flush();
}

/// Everything but the differences, which hold voxels, is text in the file. In these, fewer bytes
/// occur by chance.
bool isFoundInBytes(const QString& word)
{
    constexpr qsizetype fewest = 5;
    return isSoughtWithinWords(word) && word.toUtf8().size() >= fewest;
}

bool holdsAny(const QString& file, const QStringList& words)
{
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly))
        return true;
    const QByteArray bytes = in.readAll();
    return std::any_of(words.begin(), words.end(), [&bytes](const QString& word) {
        return isFoundInBytes(word) && bytes.contains(word.toUtf8());
    });
}

} // namespace

Result<DeidentifiedSession> deidentifySession(
    const QString& file, const QString& target, bool replaceExisting, const Deidentifier& by)
{
    const Result<SessionContents> contents = checkSession(file);
    if (!contents)
        return tl::unexpected(contents.error());
    if (!contents->isWhole())
        return failure(ErrorCode::UnsupportedFormat, file,
            Clause::saying("the session is damaged; what is sound of it has to be saved first"));
    const Result<std::unique_ptr<SessionFile>> from =
        SessionFile::open(file, SessionFile::Access::SoundPart);
    if (!from)
        return tl::unexpected(from.error());
    // What belongs to another session there would come to belong to this one, with all it tells.
    if (const Result<void> place = checkSessionPlace(target, replaceExisting); !place)
        return tl::unexpected(place.error());
    Result<StagedFile> staged = StagedFile::create(target, replaceExisting);
    if (!staged)
        return tl::unexpected(staged.error());
    SessionSource source = contents->source;
    QStringList words = by.words();
    for (const QString& each :
        {source.path, source.studyUid, source.seriesUid, source.seriesDescription}) {
        constexpr qsizetype shortest = 5; // a segment may be called as a short description
        if (each.size() >= shortest)
            words += each;
    }
    source.path.clear();
    source.studyUid.clear();
    source.seriesUid.clear();
    source.seriesDescription =
        by.options().keepDescriptions ? by.cleanText(source.seriesDescription) : QString();
    QString day = by.date(QString(source.studyDate).remove(QLatin1Char('-')));
    source.studyDate =
        day.isEmpty() ? day : day.insert(6, QLatin1Char('-')).insert(4, QLatin1Char('-'));
    if (by.options().keepDescriptions)
        words.removeAll(source.seriesDescription);
    {
        const Result<std::unique_ptr<SessionFile>> to = SessionFile::createIn(*staged, source);
        if (!to)
            return tl::unexpected(namingTarget(to.error(), *staged));
        if (const Result<void> copied = copySteps(**from, *contents, **to, by, file); !copied)
            return tl::unexpected(namingTarget(copied.error(), *staged));
    }
    const Result<SessionContents> again = checkSession(staged->path());
    if (!again)
        return tl::unexpected(namingTarget(again.error(), *staged));
    bool same =
        again->rows.size() == contents->rows.size() && again->position == contents->position;
    for (std::size_t i = 0; same && i < again->rows.size(); ++i)
        same = again->rows[i].stateHash == contents->rows[i].stateHash;
    if (!same || !again->isWhole())
        return failure(
            ErrorCode::ExportMismatch, target, Clause::saying("its steps are not those"));
    if (holdsAny(staged->path(), words))
        return failure(
            ErrorCode::ExportMismatch, target, Clause::saying("it still tells who the patient is"));
    // Somebody may have opened what lies there meanwhile.
    if (const Result<void> place = checkSessionPlace(target, replaceExisting); !place)
        return tl::unexpected(place.error());
    if (const Result<void> done = staged->commit(); !done)
        return tl::unexpected(done.error());
    return DeidentifiedSession{
        .steps = again->rows.size(), .method = by.method(), .imagesLeftOut = contents->holdsImages};
}

} // namespace core
