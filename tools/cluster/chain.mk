# The chain of a folder's chain.conf on one machine: make -j -f …/tools/cluster/chain.mk FOLDER=…
# A shard that is done already costs nothing when it is made again, and is touched. So if chain.conf, or a file that its words
# name, is newer, all shards are looked at, and those of other work are made anew.

FOLDER ?= .
here := $(dir $(realpath $(lastword $(MAKEFILE_LIST))))
include $(FOLDER)/chain.conf
step = $(here)step.sh $(FOLDER)
unquoted = $(subst ",,$(1))
shards = $(foreach k,$(shell seq $(call unquoted,$($(2)))),$(FOLDER)/shards/$(1).$(k))
# The words that are files, seen from the folder.
files = $(wildcard $(filter /%,$(1)) $(addprefix $(FOLDER)/,$(filter-out /%,$(1))))

options := $(VEHICLE) $(LATTICE) $(ROADMAP) $(PLAN) $(TRAJECTORIES) $(CHECK)
asked := $(FOLDER)/chain.conf $(call files,$(call unquoted,$(options)))

map := $(FOLDER)/city.boxmap
lattice := $(FOLDER)/city.lattice
roadmap := $(FOLDER)/city.roadmap
paths := $(FOLDER)/paths.jsonl
trajectories := $(FOLDER)/trajectories.jsonl
reports := $(FOLDER)/reports.jsonl

.PHONY: all
.DELETE_ON_ERROR:
all: $(reports)
	$(step) summary

$(map): $(asked) $(call files,$(call unquoted,$(MAP)))
	$(step) map
$(FOLDER)/shards/lattice.%: $(map) $(asked)
	$(step) lattice $* && touch $@
$(FOLDER)/shards/roadmap.%: $(map) $(asked)
	$(step) roadmap $* && touch $@
$(FOLDER)/shards/paths.%: $(lattice) $(roadmap) $(asked) $(call files,$(call unquoted,$(QUERIES)))
	$(step) paths $* && touch $@
$(FOLDER)/shards/trajectories.%: $(paths) $(asked)
	$(step) trajectories $* && touch $@
$(FOLDER)/shards/reports.%: $(trajectories) $(asked)
	$(step) reports $* && touch $@

$(lattice): $(call shards,lattice,LATTICE_SHARDS)
	$(step) join-lattice
$(roadmap): $(call shards,roadmap,ROADMAP_SHARDS)
	$(step) join-roadmap
$(paths): $(call shards,paths,PATH_SHARDS)
	$(step) join-paths
$(trajectories): $(call shards,trajectories,TRAJECTORY_SHARDS)
	$(step) join-trajectories
$(reports): $(call shards,reports,REPORT_SHARDS)
	$(step) join-reports
