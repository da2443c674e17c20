;;; axisc.el --- Axis lists of TwinCAT CNC and ISG controls  -*- lexical-binding: t -*-

;; Starts `axisc lsp' through Eglot for axis lists and machine files.

;;; Code:

(require 'eglot)

(defvar axisc-command '("axisc" "lsp")
  "What is started as language server.")

;;;###autoload
(define-derived-mode axisc-list-mode prog-mode "Axis list"
  "Axis lists, and the other lists of a control."
  (setq-local comment-start "# ")
  (setq-local comment-end ""))

(define-derived-mode axisc-machine-mode prog-mode "Machine file"
  "Machine files.")

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.lis\\'" . axisc-list-mode))
;;;###autoload
(add-to-list 'auto-mode-alist '("/machine\\.json\\'" . axisc-machine-mode))

(add-to-list 'eglot-server-programs
             (cons '(axisc-list-mode axisc-machine-mode) (lambda (&rest _) axisc-command)))

(add-hook 'axisc-list-mode-hook #'eglot-ensure)
(add-hook 'axisc-machine-mode-hook #'eglot-ensure)

(provide 'axisc)
;;; axisc.el ends here
