// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/StagedError.h"

#include "core/base/files/StagedFile.h"

#include <QFileInfo>

namespace core {

Error namingTarget(Error error, const StagedFile& staged)
{
    error.arguments.replace(staged.path(), staged.target());
    return error;
}

Clause leftElsewhere(const Clause& why, const QString& path, const QString& left)
{
    return Clause::saying("%1; what was '%2' is in '%3' now", why, QFileInfo(path).fileName(),
        QFileInfo(left).fileName());
}

Error takingBack(Error error, StagedFile& staged)
{
    const QString left = staged.takeBack();
    if (left.isEmpty())
        return error;
    const Clause reason = error.arguments.value(error.code == ErrorCode::OutOfMemory ? 0 : 1);
    const Clause why = reason.isEmpty() ? Clause::saying("it cannot be replaced") : reason;
    return {
        ErrorCode::FileUnwritable, {staged.target(), leftElsewhere(why, staged.target(), left)}};
}

} // namespace core
