#include "wirepack/io/sweep_script.hpp"

#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wirepack/core/shell_quoted.hpp"

#include "atomic_file.hpp"

namespace wirepack {

namespace {

// @NAME@ is filled in. Slurm keeps a copy of a script that it is given, so an array knows its tasks
// whatever becomes of the file.
constexpr std::string_view slurm_script = R"SCRIPT(#!/bin/bash
# Tasks of this folder as a job array of Slurm. Made by `wirepack sweep`; submits itself:
#     bash slurm.sh [options of sbatch, such as --time=24:00:00 --account=NAME]
#SBATCH --job-name=wirepack
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=@threads@
#SBATCH --signal=B:USR1@120
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=slurm/%A_%a.log

wirepack=@program@
tasks_per_job=@tasks_per_job@
most_restarts=@most_restarts@
tasks=(
@tasks@)

# Slurm numbers the elements of an array below MaxArraySize: longer lists go as several arrays.
submit() {
  command -v sbatch > /dev/null || {
    echo "slurm.sh: sbatch of Slurm is not found on this machine" >&2
    exit 5
  }
  cd "$(dirname "${BASH_SOURCE[0]}")" && mkdir -p slurm || exit 5
  local jobs=$(((${#tasks[@]} + tasks_per_job - 1) / tasks_per_job))
  local most first last
  most=$(scontrol show config | sed -n 's/^MaxArraySize *= *//p')
  for ((first = 0; first < jobs; first += ${most:-1000})); do
    last=$((first + ${most:-1000} < jobs ? ${most:-1000} - 1 : jobs - first - 1))
    sbatch --array="0-$last@at_once@" "$@" slurm.sh job "$first" || exit 5
  done
}

# Before the time limit comes USR1: the run saves, and this job is queued again. TERM, of an
# administrator or a preemption, saves too; what comes then is up to Slurm.
signalled= limit= run=
trap 'signalled=1 limit=1; kill -TERM $run 2> /dev/null' USR1
trap 'signalled=1; kill -TERM $run 2> /dev/null' TERM INT

run_task() {
  "$wirepack" run "$1/config.toml" -o "$1/run.h5" --resume --threads @threads@ --log "$1/run.log" &
  run=$!
  [[ $signalled ]] && kill -TERM "$run"
  local code
  wait "$run"
  code=$?
  # A signal ends the waiting, and not the run.
  while kill -0 "$run" 2> /dev/null; do
    wait "$run"
    code=$?
  done
  return "$code"
}

job() {
  local task code=0 worst=0
  for task in "${tasks[@]:($1 + SLURM_ARRAY_TASK_ID) * tasks_per_job:tasks_per_job}"; do
    run_task "$task"
    code=$?
    [[ $signalled ]] && break
    # 3: no equilibrium, which is a result
    [[ $code != [03] ]] && worst=$code && echo "$task: exit code $code" >&2
  done
  if [[ $limit ]]; then
    if ((${SLURM_RESTART_COUNT:-0} >= most_restarts)); then
      echo "not queued again: $most_restarts restarts are the limit" >&2
    else
      scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
    fi
  fi
  [[ $signalled ]] && exit 75
  exit "$worst"
}

if [[ ${1-} == job ]]; then
  job "$2"
else
  submit "$@"
fi
)SCRIPT";

constexpr std::string_view parallel_script = R"SCRIPT(#!/bin/bash
# Tasks of this folder by GNU parallel. Made by `wirepack sweep`:
#     bash parallel.sh [options of parallel, such as --sshloginfile hosts]
# Hosts must share this folder. It can be run again at any time: finished tasks return at once.
export wirepack=@program@
command -v parallel > /dev/null || {
  echo "parallel.sh: GNU parallel is not found on this machine" >&2
  exit 127
}
cd "$(dirname "${BASH_SOURCE[0]}")" || exit 255
run='"$wirepack" run {}/config.toml -o {}/run.h5 --resume --threads @threads@ --log {}/run.log'
# Runs that are told to end have ten minutes to save.
exec parallel --env wirepack --workdir "$PWD" --termseq TERM,600000,KILL,25 @at_once@@hosts@"$@" \
  "$run || [ \$? -eq 3 ]" << 'END'
@tasks@END
)SCRIPT";

// Snakemake removes the outputs of jobs that fail. A result is none, and a marker is.
constexpr std::string_view snakemake_script = R"SCRIPT(# Tasks of this folder for Snakemake.
# Made by `wirepack sweep`:
#     snakemake -s Snakefile --cores N [--keep-going] [--retries N]
# It can be run again at any time. A task that is finished has a file `done`.
workdir: workflow.basedir


wirepack = @program_text@
tasks = """
@tasks@""".split()


rule all:
    input:
        expand("{task}/done", task=tasks),


rule run:
    input:
        "{task}/config.toml",
    output:
        touch("{task}/done"),
    threads: @threads@
    shell:
        # 3: no equilibrium, which is a result
        "{wirepack:q} run {input:q} -o {wildcards.task:q}/run.h5 --resume --threads {threads}"
        " --log {wildcards.task:q}/run.log || [ $? -eq 3 ]"
)SCRIPT";

constexpr std::string_view hyperqueue_script = R"SCRIPT(#!/bin/bash
# Tasks of this folder by HyperQueue. Made by `wirepack sweep`:
#     bash hyperqueue.sh [options of hq submit, such as --time-request=1h]
# Server and workers run already and share this folder. It can be submitted again at any time:
# finished tasks return at once. A task that is finished has a file `done`.
wirepack=@program@
tasks=(
@tasks@)

run_task() {
  "$wirepack" run "$1/config.toml" -o "$1/run.h5" --resume --threads @threads@ --log "$1/run.log"
  local code=$?
  # 3: no equilibrium, which is a result
  [[ $code == [03] ]] || return "$code"
  touch "$1/done"
}

if [[ ${HQ_ENTRY-} ]]; then
  run_task "$HQ_ENTRY"
  exit
fi
cd "$(dirname "${BASH_SOURCE[0]}")" || exit 5
exec hq submit --name wirepack --cpus @threads@ --stdout none --stderr none \
  --each-line <(printf '%s\n' "${tasks[@]}") "$@" -- bash "$PWD/hyperqueue.sh"
)SCRIPT";

void fill_in(std::string& text, const std::string& name, const std::string& value) {
  const std::string place = "@" + name + "@";
  for (std::size_t at = 0; (at = text.find(place, at)) != std::string::npos; at += value.size()) {
    text.replace(at, place.size(), value);
  }
}

/// The file of an engine.
struct Script {
  const char* name;
  std::string_view text;
  std::string_view at_once;  ///< how it says how many tasks run at once
};

// in the order of SweepEngine
constexpr std::array<Script, 4> scripts{{{"slurm.sh", slurm_script, "%{}"},
                                         {"parallel.sh", parallel_script, "--jobs {} "},
                                         {"Snakefile", snakemake_script, ""},
                                         {"hyperqueue.sh", hyperqueue_script, ""}}};

std::string hosts_option(const std::string& file) {
  if (file.empty()) return "";
  return fmt::format("--sshloginfile {} ", shell_quoted(std::filesystem::absolute(file).string()));
}

}  // namespace

std::filesystem::path write_sweep_script(const std::filesystem::path& folder, SweepEngine engine,
                                         const std::vector<std::string>& tasks,
                                         const SweepScriptOptions& options) {
  const Script& script = scripts[static_cast<std::size_t>(engine)];
  std::string list;
  for (const std::string& task : tasks) list += task + "\n";  // names need no quotes anywhere
  std::string text(script.text);
  fill_in(text, "threads", std::to_string(options.threads));
  fill_in(text, "tasks_per_job", std::to_string(options.tasks_per_job));
  fill_in(text, "most_restarts", std::to_string(options.most_restarts));
  fill_in(text, "at_once",
          options.at_once > 0 ? fmt::format(fmt::runtime(script.at_once), options.at_once) : "");
  fill_in(text, "hosts", hosts_option(options.hosts));
  fill_in(text, "tasks", list);
  fill_in(text, "program", shell_quoted(options.program));
  fill_in(text, "program_text", nlohmann::json(options.program).dump());  // as Python has it
  const std::filesystem::path file = folder / script.name;
  replace_file(file, {text.begin(), text.end()});
  return file;
}

}  // namespace wirepack
