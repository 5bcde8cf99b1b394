#include "postGauges/Picture.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/Log.h"
#include "io/OutputFile.h"

namespace mpsDem::postGauges {

namespace fs = std::filesystem;

PictureSettings PictureSettings::read(Dictionary const& dict, PictureSettings const& defaults)
{
    static std::vector<std::string> const known = {"png", "svg"};
    PictureSettings settings = defaults;
    settings.formats = dict.getOr("formats", defaults.formats);
    for (std::string const& format : settings.formats)
        require(std::find(known.begin(), known.end(), format) != known.end(), dict.where("formats"),
                "format \"" + format + "\" is not known", knownWords("formats", format, known));
    require(!settings.formats.empty(), dict.where("formats"), "at least one format is needed", "allowed: png svg");
    settings.fontSize = static_cast<int>(dict.getInRangeOr("fontSize", defaults.fontSize, 5, 60));
    settings.keepScript = dict.getOr("keepScript", defaults.keepScript);
    return settings;
}

Picture::Picture(fs::path folder, std::string name, int width, int height, PictureSettings settings)
    : folder_(std::move(folder)),
      name_(std::move(name)),
      width_(width),
      height_(height),
      settings_(std::move(settings))
{
    makeFolder(folder_);
    std::string pattern = (folder_ / ".picture.XXXXXX").string();
    if (!::mkdtemp(pattern.data()))
        throw CaseError(ExitCode::InputOutput, Location{folder_.string(), 0, {}},
                        std::string("no folder can be made here: ") + std::strerror(errno));
    work_ = pattern;
}

Picture::~Picture()
{
    std::error_code ignored;
    fs::remove_all(work_, ignored);
}

std::string Picture::addData(std::string_view contents)
{
    std::string const name = "data" + std::to_string(files_++) + ".dat";
    OutputFile file(work_ / name);
    file.write(contents);
    file.close();
    return "'" + name + "'";
}

void Picture::writeScript() const
{
    OutputFile body(work_ / "body.gp");
    body.write(script_.str());
    body.close();
    std::ostringstream head;
    std::string const size = std::to_string(width_) + "," + std::to_string(height_);
    std::string const font = "'Sans," + std::to_string(settings_.fontSize) + "'";
    head << "set encoding utf8\nset datafile missing 'nan'\n";
    for (std::string const& format : settings_.formats)
    {
        bool const png = format == "png";
        head << "reset\nset terminal " << (png ? "pngcairo" : "svg") << " enhanced size " << size << " font " << font
             << " background '#ffffff'\n"
             << "set output 'picture." << format << "'\nload 'body.gp'\nunset output\n";
    }
    OutputFile file(work_ / "script.gp");
    file.write(head.str());
    file.close();
}

namespace {

[[noreturn]] void failed(std::string const& what, std::string const& hint = {}) { throw CaseError(ExitCode::InputOutput, what, hint); }

/// First lines of what gnuplot said.
std::string complaint(fs::path const& file)
{
    std::string const text = readBytes(file);
    std::string said;
    int lines = 0;
    for (char const c : text)
    {
        if (lines >= 8) break;
        said += c;
        if (c == '\n') ++lines;
    }
    while (!said.empty() && (said.back() == '\n' || said.back() == ' ')) said.pop_back();
    said.erase(0, std::min(said.find_first_not_of("\n "), said.size()));
    return said;
}

/// Starts a program with its output in files of `folder`. @return its exit code.
int runIn(fs::path const& folder, std::vector<std::string> words)
{
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    if (posix_spawn_file_actions_init(&actions) != 0) throw std::bad_alloc();
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "said.txt", O_WRONLY | O_CREAT | O_APPEND, 0644);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    pid_t process = 0;
    int const error = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error == ENOENT) failed(words[0] + " was not found", "Debian package: gnuplot-nox (apt-get install gnuplot-nox)");
    if (error != 0) failed(words[0] + " cannot be started: " + std::strerror(error));
    int status = 0;
    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR) failed(words[0] + ": " + std::strerror(errno));
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

} // namespace

void Picture::runGnuplot() const
{
    int const code = runIn(work_, {"gnuplot", "-d", "script.gp"});
    std::string const said = complaint(work_ / "said.txt");
    if (code != 0) failed("gnuplot failed with exit code " + std::to_string(code) + " at the picture " + name_, said);
    if (!said.empty()) warn("gnuplot at the picture " + name_ + ": " + said);
}

std::vector<fs::path> Picture::render()
{
    writeScript();
    runGnuplot();
    std::vector<fs::path> made;
    for (std::string const& format : settings_.formats)
    {
        fs::path const result = folder_ / (name_ + "." + format);
        moveFile(work_ / ("picture." + format), result);
        made.push_back(result);
    }
    if (settings_.keepScript)
    {
        fs::path const kept = folder_ / (name_ + ".gnuplot");
        removeTree(kept);
        moveFile(work_, kept);
        fs::permissions(kept, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read |
                                  fs::perms::others_exec);
    }
    return made;
}

} // namespace mpsDem::postGauges
