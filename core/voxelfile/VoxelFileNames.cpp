// SPDX-License-Identifier: Apache-2.0
#include "core/voxelfile/VoxelFileNames.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <optional>

namespace core {

namespace {

/// More files than that make up no volume, and longer names are none.
constexpr int mostVoxelFiles = 32768;
constexpr qsizetype longestName = 1024;

/// "slice%03d.raw" taken apart: what is before and behind the number, and how that is padded.
struct Pattern {
    QByteArray before;
    QByteArray behind;
    int width = 0;
    char fill = ' ';
};

std::optional<Pattern> parsed(const QByteArray& text)
{
    constexpr int widest = 20;
    Pattern pattern;
    bool numbered = false;
    for (qsizetype at = 0; at < text.size(); ++at) {
        QByteArray& into = numbered ? pattern.behind : pattern.before;
        if (text[at] != '%') {
            into += text[at];
            continue;
        }
        if (text.mid(at + 1, 1) == "%") {
            into += '%';
            ++at;
            continue;
        }
        if (numbered)
            return std::nullopt;
        qsizetype end = at + 1;
        if (end < text.size() && text[end] == '0')
            pattern.fill = '0';
        while (end < text.size() && text[end] >= '0' && text[end] <= '9') {
            pattern.width = 10 * pattern.width + (text[end] - '0');
            if (pattern.width > widest)
                return std::nullopt;
            ++end;
        }
        if (end == text.size() || (text[end] != 'd' && text[end] != 'i' && text[end] != 'u'))
            return std::nullopt;
        numbered = true;
        at = end;
    }
    return numbered ? std::optional(pattern) : std::nullopt;
}

/// None: no such pattern, or too many.
std::optional<QList<QByteArray>> numberedNames(
    const QByteArray& pattern, qint64 first, qint64 last, qint64 step)
{
    constexpr qint64 greatest = qint64(1) << 31;
    const auto isNear = [](qint64 number) { return number > -greatest && number < greatest; };
    const std::optional<Pattern> name = parsed(pattern);
    if (!name || !isNear(first) || !isNear(last) || !isNear(step) || step == 0)
        return std::nullopt;
    if (last != first && (last < first) != (step < 0))
        return std::nullopt;
    const qint64 count = (last - first) / step + 1;
    if (count > mostVoxelFiles)
        return std::nullopt;
    QList<QByteArray> names;
    for (qint64 index = 0; index < count; ++index) {
        QByteArray number = QByteArray::number(first + index * step);
        number = number.rightJustified(name->width, name->fill);
        names.append(name->before + number + name->behind);
    }
    return names;
}

/// "slice%03d.raw 1 40 1" or with one number more; none: not numbered.
std::optional<QList<QByteArray>> numberedFiles(const QByteArray& text)
{
    const QList<QByteArray> words = text.simplified().split(' ');
    for (const qsizetype count : {4, 3}) {
        const qsizetype from = words.size() - count;
        const QByteArray pattern = words.mid(0, from).join(' ');
        if (from < 1 || !pattern.contains('%'))
            continue;
        bool whole = true;
        std::array<qint64, 4> range{};
        for (qsizetype part = 0; part < count; ++part) {
            bool isNumber = false;
            range[std::size_t(part)] = words[from + part].toLongLong(&isNumber);
            whole = whole && isNumber;
        }
        if (whole)
            return numberedNames(pattern, range[0], range[1], range[2]);
    }
    return std::nullopt;
}

} // namespace

bool isFileList(const QByteArray& word)
{
    return word == "LIST" || word.startsWith("LIST ");
}

Result<QStringList> namedVoxelFiles(
    const QString& header, const QByteArray& word, const QList<QByteArray>& list)
{
    QList<QByteArray> names{word};
    if (isFileList(word))
        names = list;
    else if (word.size() > longestName)
        names.clear();
    else if (auto numbered = numberedFiles(word))
        names = std::move(*numbered);
    const bool sound = !names.isEmpty() && names.size() <= mostVoxelFiles
        && std::none_of(names.begin(), names.end(), [](const QByteArray& name) {
               return name.isEmpty() || name.size() > longestName || name.contains('\0');
           });
    if (!sound)
        return failure(ErrorCode::FileUnreadable, header,
            Clause::saying("its header names no files that hold the voxels"));
    const QDir folder = QFileInfo(header).absoluteDir();
    QStringList files;
    for (const QByteArray& name : names)
        files.append(QDir::cleanPath(folder.filePath(QString::fromUtf8(name))));
    return files;
}

} // namespace core
