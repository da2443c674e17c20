;;; What Emacs shows of the samples, and what it does to them.  -*- lexical-binding: t -*-

(require 'axisc)
(require 'flymake)
(require 'json)

(defvar test-folder (getenv "AXISC_SAMPLES"))
(setq axisc-command (list (getenv "AXISC_SERVER"))
      eglot-sync-connect 20
      eglot-confirm-server-initiated-edits nil
      flymake-no-changes-timeout 0.1
      eglot-send-changes-idle-time 0.05
      create-lockfiles nil
      make-backup-files nil)

(defun test-check (condition what)
  (unless condition (error "%s" what)))

(defun test-wait (condition what)
  (let ((end (+ (float-time) 20)))
    (while (and (not (funcall condition)) (< (float-time) end))
      (accept-process-output nil 0.02))
    (test-check (funcall condition) what)))

(defun test-open (file)
  (find-file (expand-file-name file test-folder))
  (unless (eglot-current-server) (apply #'eglot (eglot--guess-contact)))
  (flymake-mode 1)
  (test-wait #'eglot-current-server (concat file " has no server")))

(defun test-lint (input wanted)
  (let* ((text (with-temp-buffer
                 (call-process "axisc" nil '(t nil) nil "lint" (expand-file-name input test-folder) "--format" "json")
                 (buffer-string)))
         (findings (alist-get 'diagnostics (json-read-from-string text))))
    (seq-filter (lambda (finding)
                  (equal (file-name-nondirectory (alist-get 'file finding)) wanted))
                findings)))

(defun test-shown ()
  (mapcar (lambda (shown) (line-number-at-pos (flymake-diagnostic-beg shown))) (flymake-diagnostics)))

;; The same lines.
(defun test-equals-lint (input file)
  (test-open file)
  (let ((lines (sort (mapcar (lambda (finding) (alist-get 'line finding))
                             (test-lint input (file-name-nondirectory file)))
                     #'<)))
    (flymake-start)
    (test-wait (lambda () (equal (sort (test-shown) #'<) lines)) (format "%s shows not what lint says" file))))

(defun test-ask (method &rest more)
  (jsonrpc-request (eglot-current-server) method
                   (append (eglot--TextDocumentPositionParams) more)))

(test-equals-lint "mistakes/typing.lis" "mistakes/typing.lis")
(test-equals-lint "mistakes/controller/listen/hochlauf.lis" "mistakes/controller/listen/sda_mds1.lis")
(test-equals-lint "mill/machine.json" "mill/x.lis")

(test-open "mill/default.lis")
(goto-char (point-min))
(search-forward "filter[0].fg_f0")
(test-check (string-match-p "P-AXIS-00067" (plist-get (plist-get (test-ask :textDocument/hover) :contents) :value))
            "the page of a name")
(search-forward "42")
(test-check (string-match-p "42 Hz" (plist-get (plist-get (test-ask :textDocument/hover) :contents) :value))
            "the quantity of a value")

;; What ElDoc shows.
(let (shown)
  (eglot-hover-eldoc-function (lambda (text &rest _) (setq shown text)))
  (test-wait (lambda () (and shown (string-match-p "42 Hz" shown))) "the quantity at point"))

;; Completion through the editor's own command.
(end-of-line)
(insert "\nfilter[0].prot")
(eglot--signal-textDocument/didChange)
(completion-at-point)
(test-check (save-excursion (beginning-of-line) (looking-at-p "filter\\[0\\]\\.prototype")) "names are completed")
(delete-region (line-beginning-position) (line-end-position))
(delete-char -1)

;; A mistake, and its fix.
(beginning-of-line)
(search-forward "42" (line-end-position))
(insert ",5")
(eglot--signal-textDocument/didChange)
(test-wait (lambda () (flymake-start) (memq (line-number-at-pos) (test-shown))) "the mistake is shown")
(cl-letf (((symbol-function 'completing-read) (lambda (_prompt choices &rest _) (caar choices)))
          ((symbol-function 'x-popup-menu) (lambda (_event menu) (cdr (cadr (cadr menu))))))
  (eglot-code-actions (line-beginning-position) (line-end-position) "quickfix" t))
(test-wait (lambda () (save-excursion (beginning-of-line) (search-forward "42.5" (line-end-position) t)))
           "the fix is applied")

;; Layout as fmt writes it.
(beginning-of-line)
(kill-line)
(insert "filter[0].fg_f0 42 ( Hz")
(let ((copy (make-temp-file "axisc" nil ".lis")))
  (write-region nil nil copy nil 'silent)
  (call-process "axisc" nil nil nil "fmt" copy)
  (eglot-format-buffer)
  (test-check (equal (buffer-string) (with-temp-buffer (insert-file-contents copy) (buffer-string)))
              "the layout is that of fmt")
  (delete-file copy))

;; What is not open counts as soon as the disk has it: eglot watches for the server, below the folder of the first file.
(test-open "mistakes/controller/listen/sda_mds1.lis")
(flymake-start)
(test-wait #'test-shown "findings in the machine")
(let* ((machine (expand-file-name "mistakes/controller/listen/hochlauf.lis" test-folder))
       (elsewhere (make-temp-file "axisc"))
       (within (sort (test-shown) #'<))
       (becomes (lambda (condition what)
                  (test-wait (lambda () (read-event nil nil 0.02) (flymake-start) (funcall condition)) what))))
  (copy-file machine elsewhere t)
  (delete-file machine)
  (funcall becomes (lambda () (not (equal (sort (test-shown) #'<) within))) "the list stands alone without its machine")
  (copy-file elsewhere machine)
  (funcall becomes (lambda () (equal (sort (test-shown) #'<) within)) "the machine counts again")
  (delete-file elsewhere))

;; Settings apply at once.
(test-open "manual/axis-pt1.lis")
(test-wait (lambda () (flymake-start) (test-shown)) "a list alone has no cycle time")
(setq-default eglot-workspace-configuration '((:axisc . (:cycleTime "1ms"))))
(eglot-signal-didChangeConfiguration (eglot-current-server))
(test-wait (lambda () (flymake-start) (not (test-shown))) "the cycle time of the settings counts")

(dolist (buffer (buffer-list))
  (with-current-buffer buffer (set-buffer-modified-p nil)))
(eglot-shutdown (eglot-current-server))
