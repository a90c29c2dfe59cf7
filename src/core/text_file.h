// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

namespace agv {

/// The whole of a regular file. NotFound, Permission, BadInput (a directory, a device, larger than `limit`
/// bytes) or Io; the message names the file.
Result<std::string> readTextFile(const std::filesystem::path& path, std::size_t limit);

/// The same of anything that can be read to its end, pipes and terminals too; waits for who writes there.
Result<std::string> readTextStream(const std::filesystem::path& path, std::size_t limit);
Result<std::string> readTextStream(std::istream& in, const std::string& name, std::size_t limit);

/// Replaces the file by one that holds `text`: written beside it, synchronised to the disk, renamed. At
/// every instant the file holds the old or the new text. Its permissions are kept; a symbolic link stays
/// and the file it names is replaced or made. BadInput (a directory), NotFound, Permission or Io; then
/// nothing is left behind.
///
/// What is no regular file (a pipe, a terminal, a null device, /dev/stdout) is never replaced: the text is
/// written into it. That waits for the reader of a pipe.
Result<void> writeTextFile(const std::filesystem::path& path, std::string_view text);

/// To be called right after the writing: sends what was written to `out`, standard output, on its way. Io
/// when a part of it did not arrive, now or before: a full disk, a reader that went away.
Result<void> flushStandardOutput(std::ostream& out);

/// Whether writeTextFile() may write there, as far as can be told before; changes nothing. The same errors.
Result<void> checkWritable(const std::filesystem::path& path);

} // namespace agv
